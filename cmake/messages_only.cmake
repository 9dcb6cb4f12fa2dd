# SPDX-License-Identifier: BSD-3-Clause
# line_plane_segmentation/PlaneArray and Plane for C++ and Python, on a computer that receives planes and finds none.
find_package(catkin REQUIRED COMPONENTS geometry_msgs message_generation shape_msgs std_msgs)
include(cmake/messages.cmake)
catkin_package(CATKIN_DEPENDS geometry_msgs message_runtime shape_msgs std_msgs)
