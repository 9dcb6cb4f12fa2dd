// SPDX-License-Identifier: BSD-3-Clause
#include "bag_input.h"

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <array>
#include <boost/function.hpp>
#include <fstream>

#include "bag_index.h"
#include "run_tool.h"

namespace line_plane_segmentation {
namespace {

using Query = boost::function<bool(const rosbag::ConnectionInfo*)>;

/// Some of a bag's messages, in the order of recording times.
class Messages {
 public:
  Messages(const rosbag::Bag& bag, const Query& query) : view_(bag, query), next_(view_.begin()) {}

  bool atEnd() { return next_ == view_.end(); }
  ros::Time time() { return next_->getTime(); }
  const rosbag::MessageInstance& current() { return *next_; }
  void advance() { ++next_; }
  std::uint32_t size() { return view_.size(); }

 private:
  rosbag::View view_;
  rosbag::View::iterator next_;
};

class IndexedBag : public BagInput {
 public:
  IndexedBag(std::unique_ptr<rosbag::Bag> bag, const MessageFilter& wanted)
      : bag_(std::move(bag)),
        images_(
            *bag_,
            [&wanted](const auto* from) { return !isSmall(*from) && wanted(from->topic, from->datatype); }),
        others_(
            *bag_,
            [&wanted](const auto* from) { return isSmall(*from) && wanted(from->topic, from->datatype); }),
        size_(images_.size() + others_.size()) {
    rosbag::View all(*bag_);
    for (const rosbag::ConnectionInfo* connection : all.getConnections()) {
      topics_[connection->topic] = connection->datatype;
    }
  }

  bool next(BagMessage& message) override {
    for (;;) {
      if (images_.atEnd() && others_.atEnd()) return false;
      Messages& from =
          images_.atEnd() || (!others_.atEnd() && others_.time() <= images_.time()) ? others_ : images_;
      ++read_;
      const bool is_readable = read(from.current(), message);
      from.advance();
      if (is_readable) return true;
    }
  }

  double fractionRead() const override { return size_ == 0 ? 1.0 : static_cast<double>(read_) / size_; }
  const std::map<std::string, std::string>& topics() const override { return topics_; }
  const std::string& damage() const override { return damage_; }

 private:
  // Recorded at the same time as an image, what belongs to it comes first: rosbag's own order of equal times
  // is by topic, so that in a bag of one time all images could come before the first camera_info.
  static bool isSmall(const rosbag::ConnectionInfo& connection) {
    return connection.datatype == "sensor_msgs/CameraInfo" || connection.datatype == "tf2_msgs/TFMessage" ||
           connection.datatype == "tf/tfMessage";
  }

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
  Messages images_;
  Messages others_;
  std::uint32_t size_;
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
  const bool is_current = version == "#ROSBAG V2.0";
  const std::string encryptor = is_current ? encryptorOf(file) : "";
  const std::string broken = is_current ? problemOfIndex(file) : "";
  if (!broken.empty()) return openDamagedBag(file, wanted, broken);
  try {
    return std::make_unique<IndexedBag>(std::make_unique<rosbag::Bag>(name), wanted);
  } catch (const rosbag::BagUnindexedException&) {
    return openDamagedBag(file, wanted, "it has no index: the recording was not finished");
  } catch (const std::exception& problem) {
    if (!encryptor.empty()) throw BadInput(name + ": is encrypted with " + encryptor + ", " + problem.what());
    if (!is_current) throw BadInput(name + ": cannot be read, " + problem.what());
    return openDamagedBag(file, wanted, "its index is missing or broken");
  }
}

}  // namespace line_plane_segmentation
