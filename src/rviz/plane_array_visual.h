// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OgrePrerequisites.h>
#include <line_plane_segmentation/PlaneArray.h>

#include <memory>
#include <string>
#include <vector>

#include "plane_style.h"

namespace rviz {
class Arrow;
class MovableText;
}  // namespace rviz

namespace line_plane_segmentation {

/// Draws the planes of one message. Used by rviz's own thread alone.
class PlaneArrayVisual {
 public:
  PlaneArrayVisual(Ogre::SceneManager& scene_manager, Ogre::SceneNode& parent);
  ~PlaneArrayVisual();
  PlaneArrayVisual(const PlaneArrayVisual&) = delete;
  PlaneArrayVisual& operator=(const PlaneArrayVisual&) = delete;

  /// Replaces what was drawn.
  void draw(const PlaneArray& planes, const PlaneStyle& style);

  /// Pose of the message's frame in rviz's fixed frame.
  void setPose(const Ogre::Vector3& position, const Ogre::Quaternion& orientation);

 private:
  void drawSurfaces(const PlaneArray& planes, const PlaneStyle& style);
  void drawOutlines(const PlaneArray& planes, const PlaneStyle& style);
  void addNormal(const Plane& plane, const PlaneStyle& style);
  void addText(const Plane& plane, const PlaneStyle& style);

  Ogre::SceneManager& scene_manager_;
  Ogre::SceneNode* node_;
  std::string material_;
  Ogre::ManualObject* surfaces_;
  Ogre::ManualObject* outlines_;
  std::vector<std::unique_ptr<rviz::Arrow>> normals_;
  std::vector<std::unique_ptr<rviz::MovableText>> texts_;
  std::vector<Ogre::SceneNode*> text_nodes_;
};

}  // namespace line_plane_segmentation
