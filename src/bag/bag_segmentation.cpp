// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <deque>
#include <map>
#include <numeric>
#include <optional>

#include "bag_input.h"
#include "bag_output.h"
#include "bag_task.h"
#include "bag_transforms.h"
#include "depth_topics.h"
#include "frame_segmenter.h"
#include "interruption.h"
#include "ordered_work.h"
#include "output_files.h"
#include "plane_locator.h"
#include "planes_csv.h"
#include "progress.h"
#include "robot_messages.h"
#include "run_tool.h"
#include "topic_help.h"

namespace line_plane_segmentation {
namespace {

/// A frame in processing.
struct Slot {
  BagFrame frame;
  FrameSegmenter segmenter;
};

class BagSegmentation {
 public:
  explicit BagSegmentation(const BagTask& task)
      : task_(task), topics_(task.topics), in_(openBag(task.in, [this](const auto& topic, const auto& type) {
          return task_.input || topics_.wants(topic, type) ||
                 (needsTransforms() && BagTransforms::wants(topic, type));
        })) {
    topics_.setBagTopics(in_->topics());
    robot_.setParameters(RobotParameters{}, task_.parameters.noise, task_.location.tracking);
  }

  void run() {
    checkNamedTopics();
    // Until here no file was created that an interruption would have to remove.
    catchInterruption();
    OutputFiles files;
    files.protect(task_.in);
    out_.emplace(files.reserve(task_.out), task_.out.string(), task_.compression);
    if (!task_.csv.empty()) csv_.emplace(files, task_.csv);

    std::vector<Slot> slots;
    for (std::size_t i = 0; i < slotsForAllCores(); ++i) slots.push_back({{}, FrameSegmenter(task_.limits)});
    for (Slot& slot : slots) slot.segmenter.setParameters(task_.parameters);
    workInOrder(
        slots, [this](Slot& slot) { return fill(slot); },
        [](Slot& slot) { slot.segmenter.segment(slot.frame.messages); }, [this](Slot& slot) { write(slot); });
    progress_.clear();

    if (done_ == 0) throw BadInput(task_.in.string() + ": " + whyNothing());
    out_->close();
    files.commit();
    printSummary();
    const std::string damage = damageText();
    if (!damage.empty()) throw BadInput(task_.in.string() + ": " + damage + "; what could be read is done");
    const std::string unknown_frames = unknownFrames();
    if (!unknown_frames.empty()) throw BadInput(task_.in.string() + ": " + unknown_frames);
  }

 private:
  void checkNamedTopics() const {
    if (in_->topics().empty()) return;
    for (const std::string& name : task_.topics.images) {
      if (typeOf(name) == "sensor_msgs/Image" || typeOf(name) == "sensor_msgs/CompressedImage") continue;
      if (!typeOf(name + "/compressedDepth").empty() || !typeOf(name + "/compressed").empty()) continue;
      checkIsThere(name);
      throw BadInput(task_.in.string() + ": " + name + " is " + typeOf(name) + ", not an image");
    }
    for (const std::string& name : task_.topics.infos) {
      checkIsThere(name);
      if (typeOf(name) == "sensor_msgs/CameraInfo") continue;
      throw BadInput(task_.in.string() + ": " + name + " is " + typeOf(name) +
                     ", not sensor_msgs/CameraInfo");
    }
  }

  void checkIsThere(const std::string& name) const {
    if (!typeOf(name).empty()) return;
    throw BadInput(task_.in.string() + ": has no topic " + name + "; " +
                   describeTopics(in_->topics(), topics_));
  }

  // Empty if there is no such topic.
  std::string typeOf(const std::string& topic) const {
    const auto found = in_->topics().find(topic);
    return found == in_->topics().end() ? std::string() : found->second;
  }

  bool needsTransforms() const { return task_.location.frames.any(); }

  // Reads the next message of the bag. Returns false at its end.
  bool readOne() {
    stopIfInterrupted();
    BagMessage message;
    if (!in_->next(message)) return false;
    read_until_ = message.time;
    if (task_.input) out_->copy(message);
    try {
      topics_.add(message, ready_);
      if (needsTransforms()) transforms_.add(message);
    } catch (const std::exception& error) {
      ++broken_messages_;
      broken_ = message.topic + ", " + error.what();
    }
    return true;
  }

  bool fill(Slot& slot) {
    stopIfInterrupted();
    while (ready_.empty()) {
      if (readOne()) continue;
      topics_.finish(ready_);
      if (ready_.empty()) return false;
    }
    slot.frame = ready_.front();
    ready_.pop_front();
    return true;
  }

  // Called in the order of the images, on which the ids depend.
  void write(Slot& slot) {
    DepthTopic& topic = *slot.frame.topic;
    FrameSegmenter& segmenter = slot.segmenter;
    const Validation& input = segmenter.input();
    PlaneLocator& locator = locatorOf(topic);
    CameraPoses poses;
    if (!input.accepted()) {
      refuse(topic, segmenter.explanation(slot.frame.messages));
    } else if (poses = lookUpPoses(slot.frame, locator, segmenter.header()); !poses.target.found()) {
      refuse(topic, "planes cannot be given in target_frame: " + poses.target.problem);
    } else {
      gravity_found_ = gravity_found_ || poses.gravity.found();
      fixed_found_ = fixed_found_ || poses.fixed.found();
      const Segmentation& segmentation = segmenter.segmentation();
      writeMessages(slot,
                    segmenter.result(locator.locate(segmentation, input.camera, segmenter.header(), poses)));
      ++topic.frames;
      topic.planes += segmentation.planes.size();
      ++done_;
    }
    progress_.update(done_, in_->fractionRead());
  }

  static void refuse(DepthTopic& topic, const std::string& reason) {
    ++topic.refused;
    topic.refusal = reason;
  }

  PlaneLocator& locatorOf(const DepthTopic& topic) {
    const auto [locator, is_new] = locators_.try_emplace(&topic, transforms_.buffer());
    if (is_new) locator->second.setParameters(task_.location);
    return locator->second;
  }

  // The nodelet waits for late or first transforms; here the bag is read ahead instead.
  CameraPoses lookUpPoses(const BagFrame& frame, PlaneLocator& locator, const std_msgs::Header& header) {
    constexpr std::size_t kMaxWaiting = 64;  // frames, however little the recording times advance
    const double latest = frame.time.toSec() + task_.location.frames.tf_patience;
    CameraPoses poses = locator.lookUp(header);
    const auto may_become_available = [&poses] {
      return poses.has(TransformLookup::Status::kLate) || poses.has(TransformLookup::Status::kUnknown);
    };
    while (may_become_available() && read_until_.toSec() < latest && ready_.size() < kMaxWaiting &&
           readOne()) {
      poses = locator.lookUp(header);
    }
    locator.fallBack(header, poses);
    return poses;
  }

  void writeMessages(Slot& slot, const SegmentedFrame& result) {
    const BagFrame& frame = slot.frame;
    const std::string& name = frame.topic->result_namespace;
    const PlaneArray::Ptr planes = planesMessage(result);
    out_->write(name + "/planes", frame.time, *planes);
    if (csv_) csv_->add(frame.topic->image, *planes);
    if (task_.labels) out_->write(name + "/labels", frame.time, *labelsImage(result));
    if (task_.cloud) out_->write(name + "/cloud", frame.time, *coloredCloud(result));
    if (task_.overlay) out_->write(name + "/overlay", frame.time, *overlayImage(result));
    if (task_.markers) {
      robot_.setFrame(result);
      const visualization_msgs::MarkerArray::Ptr markers = planeMarkers(result);
      robot_.addObjectMarkers(*markers);
      out_->write(name + "/markers", frame.time, *markers);
    }
    if (task_.scanlines) {
      FrameSegmenter& segmenter = slot.segmenter;
      out_->write(name + "/scanlines", frame.time,
                  *scanlineMarkers(result, segmenter.lineSegments(), segmenter.candidates()));
    }
  }

  std::string whyNothing() const {
    std::string text = damageText();
    if (!text.empty()) text += "; ";
    if (topics_.all().empty())
      return text + "holds no depth images; " + describeTopics(in_->topics(), topics_);
    const DepthTopic& topic = topics_.all().front();
    if (topic.refused > 0) return text + topic.image + ": " + topic.refusal;
    return text + "none of the " + std::to_string(topic.images) + " images of " + topic.image +
           " has a camera_info" + (topic.info.empty() ? "" : " on " + topic.info) + "; " +
           describeInfoOptions(topics_.infoTopics());
  }

  // Names the frame parameters that were never found, which are probably misspelt.
  std::string unknownFrames() const {
    const FrameParameters& frames = task_.location.frames;
    const std::string hint = "': its transforms lead there for no image; all else is done";
    if (!frames.gravity_frame.empty() && !gravity_found_) {
      return "orientations are unknown in gravity_frame '" + frames.gravity_frame + hint;
    }
    if (!frames.fixed_frame.empty() && !fixed_found_) {
      return "the camera's motion is unknown in fixed_frame '" + frames.fixed_frame + hint;
    }
    return {};
  }

  std::string damageText() const {
    if (broken_messages_ == 0) return in_->damage();
    const std::string text = std::to_string(broken_messages_) + " broken messages (" + broken_ + ")";
    return in_->damage().empty() ? text : in_->damage() + ", " + text;
  }

  void printSummary() const {
    for (const DepthTopic& topic : topics_.all()) {
      std::printf("%s -> %s: %zu frames, %zu planes", topic.image.c_str(), topic.result_namespace.c_str(),
                  topic.frames, topic.planes);
      const std::size_t unpaired = topic.images - topic.frames - topic.refused;
      if (unpaired > 0) std::printf(", %zu images without camera_info", unpaired);
      if (topic.approximate > 0)
        std::printf(", %zu with the newest camera_info of %s", topic.approximate, topic.info.c_str());
      if (topic.refused > 0) std::printf(", %zu refused: %s", topic.refused, topic.refusal.c_str());
      std::printf("\n");
    }
  }

  const BagTask& task_;
  DepthTopics topics_;
  std::unique_ptr<BagInput> in_;
  std::optional<BagOutput> out_;
  std::optional<PlanesCsv> csv_;
  Progress progress_;
  std::deque<BagFrame> ready_;
  BagTransforms transforms_;
  ros::Time read_until_;
  std::map<const DepthTopic*, PlaneLocator> locators_;
  RobotMessages robot_{"segment_bag"};  // for the objects among the markers
  bool gravity_found_ = false;
  bool fixed_found_ = false;
  std::size_t done_ = 0;
  std::size_t broken_messages_ = 0;
  std::string broken_;
};

}  // namespace

void segmentBag(const BagTask& task) { BagSegmentation(task).run(); }

}  // namespace line_plane_segmentation
