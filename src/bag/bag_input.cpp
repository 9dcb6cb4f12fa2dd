// SPDX-License-Identifier: BSD-3-Clause
#include "bag_input.h"

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <fstream>

#include "run_tool.h"

namespace line_plane_segmentation {
namespace {

class IndexedBag : public BagInput {
 public:
  IndexedBag(std::unique_ptr<rosbag::Bag> bag, const MessageFilter& wanted)
      : bag_(std::move(bag)), view_(*bag_, [&wanted](const rosbag::ConnectionInfo* connection) {
          return wanted(connection->topic, connection->datatype);
        }) {
    rosbag::View all(*bag_);
    for (const rosbag::ConnectionInfo* connection : all.getConnections()) {
      topics_[connection->topic] = connection->datatype;
    }
    next_ = view_.begin();
  }

  bool next(BagMessage& message) override {
    for (; next_ != view_.end(); ++next_) {
      ++read_;
      if (!read(*next_, message)) continue;
      ++next_;
      return true;
    }
    return false;
  }

  double share() const override { return size_ == 0 ? 1.0 : static_cast<double>(read_) / size_; }
  const std::map<std::string, std::string>& topics() const override { return topics_; }
  const std::string& damage() const override { return damage_; }

 private:
  bool read(const rosbag::MessageInstance& from, BagMessage& message) {
    try {
      message = {from.getTopic(), from.getTime(), from.instantiate<topic_tools::ShapeShifter>(),
                 from.getConnectionHeader()};
      return message.content != nullptr;
    } catch (const std::exception& error) {
      ++unreadable_;
      damage_ = std::to_string(unreadable_) + " messages cannot be read (" + error.what() + ")";
      return false;
    }
  }

  std::unique_ptr<rosbag::Bag> bag_;
  rosbag::View view_;
  rosbag::View::iterator next_;
  std::uint32_t size_ = view_.size();
  std::uint32_t read_ = 0;
  std::uint32_t unreadable_ = 0;
  std::map<std::string, std::string> topics_;
  std::string damage_;
};

// The first line of a bag states its version.
std::string firstLine(const std::filesystem::path& file) {
  constexpr std::size_t kLongest = 32;
  std::ifstream stream(file, std::ios::binary);
  std::string line(kLongest, '\0');
  stream.read(line.data(), kLongest);
  line.resize(static_cast<std::size_t>(stream.gcount()));
  return line.substr(0, line.find('\n'));
}

}  // namespace

std::unique_ptr<BagInput> openBag(const std::filesystem::path& file, const MessageFilter& wanted) {
  const std::string name = file.string();
  std::error_code error;
  if (!std::filesystem::exists(file, error)) throw BadInput(name + ": no such file");
  if (!std::filesystem::is_regular_file(file, error)) throw BadInput(name + ": is not a file");
  const std::string version = firstLine(file);
  if (version.rfind("#ROSBAG V", 0) != 0) throw BadInput(name + ": is not a bag");
  try {
    return std::make_unique<IndexedBag>(std::make_unique<rosbag::Bag>(name), wanted);
  } catch (const rosbag::BagUnindexedException&) {
    return openDamagedBag(file, wanted, "it has no index: the recording was not finished");
  } catch (const std::exception& problem) {
    if (version != "#ROSBAG V2.0") throw BadInput(name + ": cannot be read, " + problem.what());
    return openDamagedBag(file, wanted, "its index is missing or broken");
  }
}

}  // namespace line_plane_segmentation
