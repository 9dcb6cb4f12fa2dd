# SPDX-License-Identifier: BSD-3-Clause
add_message_files(FILES
  Plane.msg PlaneArray.msg SupportedObject.msg SupportedObjectArray.msg TrackedPlane.msg TrackedPlaneArray.msg)
generate_messages(DEPENDENCIES geometry_msgs shape_msgs std_msgs)
