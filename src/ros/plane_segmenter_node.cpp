// SPDX-License-Identifier: BSD-3-Clause
// The nodelet as a node. It is linked, not loaded as a plugin, so that debuggers and sanitizers work.
#include <nodelet/loader.h>
#include <ros/ros.h>

#include <boost/function.hpp>
#include <boost/make_shared.hpp>
#include <string>

#include "plane_segmenter_nodelet.h"

int main(int argc, char** argv) {
  ros::init(argc, argv, "plane_segmenter");
  const boost::function<boost::shared_ptr<nodelet::Nodelet>(const std::string&)> create =
      [](const std::string& /*type*/) {
        return boost::make_shared<line_plane_segmentation::PlaneSegmenterNodelet>();
      };
  nodelet::Loader loader(create);
  if (!loader.load(ros::this_node::getName(), "line_plane_segmentation/plane_segmenter",
                   ros::names::getRemappings(), {})) {
    return 1;
  }
  ros::spin();
  return 0;
}
