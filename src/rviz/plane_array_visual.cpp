// SPDX-License-Identifier: BSD-3-Clause
#include "plane_array_visual.h"

#include <OgreManualObject.h>
#include <OgreMaterialManager.h>
#include <OgreResourceGroupManager.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <OgreTechnique.h>
#include <rviz/ogre_helpers/arrow.h>
#include <rviz/ogre_helpers/movable_text.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "normal_uncertainty.h"
#include "polygon_fill.h"

namespace line_plane_segmentation {
namespace {

const Ogre::String& resource_group = Ogre::ResourceGroupManager::DEFAULT_RESOURCE_GROUP_NAME;

Ogre::Vector3 toOgre(const Eigen::Vector3f& v) { return {v.x(), v.y(), v.z()}; }
Ogre::Vector3 toOgre(const geometry_msgs::Point32& p) { return {p.x, p.y, p.z}; }
Ogre::Vector3 toOgre(const geometry_msgs::Point& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

Ogre::Vector3 normalOf(const Plane& plane) {
  const auto& coef = plane.coefficients.coef;
  return {static_cast<float>(coef[0]), static_cast<float>(coef[1]), static_cast<float>(coef[2])};
}

Ogre::ColourValue toOgre(const Color& color, float alpha) {
  return Ogre::ColourValue(static_cast<float>(color.r) / 255.0F, static_cast<float>(color.g) / 255.0F,
                           static_cast<float>(color.b) / 255.0F, alpha);
}

// A name of its own for each visual that exists.
std::string materialName(const PlaneArrayVisual* visual) {
  return "line_plane_segmentation_planes_" + std::to_string(reinterpret_cast<std::uintptr_t>(visual));
}

// Draws vertex colours as they are, seen from both sides.
void makeMaterial(const std::string& name) {
  const Ogre::MaterialPtr material = Ogre::MaterialManager::getSingleton().create(name, resource_group);
  material->setReceiveShadows(false);
  material->setLightingEnabled(false);
  material->setCullingMode(Ogre::CULL_NONE);
  material->setSceneBlending(Ogre::SBT_TRANSPARENT_ALPHA);
  material->setDepthWriteEnabled(false);
}

void addTriangle(Ogre::ManualObject& object, const Triangle& triangle, const Ogre::ColourValue& color) {
  for (const Eigen::Vector3f& corner : triangle) {
    object.position(toOgre(corner));
    object.colour(color);
  }
}

void addRing(Ogre::ManualObject& object, const geometry_msgs::Polygon& ring, const Ogre::ColourValue& color) {
  for (std::size_t i = 0; i < ring.points.size(); ++i) {
    for (const std::size_t end : {i, (i + 1) % ring.points.size()}) {
      object.position(toOgre(ring.points[end]));
      object.colour(color);
    }
  }
}

}  // namespace

PlaneArrayVisual::PlaneArrayVisual(Ogre::SceneManager& scene_manager, Ogre::SceneNode& parent)
    : scene_manager_(scene_manager), node_(parent.createChildSceneNode()), material_(materialName(this)) {
  makeMaterial(material_);
  surfaces_ = scene_manager_.createManualObject(material_ + "_surfaces");
  outlines_ = scene_manager_.createManualObject(material_ + "_outlines");
  for (Ogre::ManualObject* object : {surfaces_, outlines_}) {
    object->setDynamic(true);
    node_->attachObject(object);
  }
}

PlaneArrayVisual::~PlaneArrayVisual() {
  draw(PlaneArray(), PlaneStyle());
  scene_manager_.destroyManualObject(surfaces_);
  scene_manager_.destroyManualObject(outlines_);
  scene_manager_.destroySceneNode(node_);
  Ogre::MaterialManager::getSingleton().remove(material_, resource_group);
}

void PlaneArrayVisual::setPose(const Ogre::Vector3& position, const Ogre::Quaternion& orientation) {
  node_->setPosition(position);
  node_->setOrientation(orientation);
}

void PlaneArrayVisual::draw(const PlaneArray& planes, const PlaneStyle& style) {
  normals_.clear();
  for (const auto& text : texts_) text->detachFromParent();
  texts_.clear();
  for (Ogre::SceneNode* node : text_nodes_) scene_manager_.destroySceneNode(node);
  text_nodes_.clear();
  drawSurfaces(planes, style);
  drawOutlines(planes, style);
  for (const Plane& plane : planes.planes) {
    if (style.normals) addNormal(plane, style);
    if (style.ids) addText(plane, style);
  }
}

void PlaneArrayVisual::drawSurfaces(const PlaneArray& planes, const PlaneStyle& style) {
  surfaces_->clear();
  std::vector<std::pair<Triangle, Ogre::ColourValue>> triangles;
  for (const Plane& plane : planes.planes) {
    const Color color = colorOf(plane, style.color_by);
    if (style.fill) {
      for (const Triangle& triangle : fillOf(plane))
        triangles.emplace_back(triangle, toOgre(color, style.alpha));
    }
    if (style.covariance) {
      for (const Triangle& triangle : normalDisc(plane, style.normal_length, style.covariance_scale)) {
        triangles.emplace_back(triangle, toOgre(color, std::max(style.alpha, 0.5F)));
      }
    }
  }
  if (triangles.empty()) return;
  surfaces_->estimateVertexCount(3 * triangles.size());
  surfaces_->begin(material_, Ogre::RenderOperation::OT_TRIANGLE_LIST, resource_group);
  for (const auto& [triangle, color] : triangles) addTriangle(*surfaces_, triangle, color);
  surfaces_->end();
}

void PlaneArrayVisual::drawOutlines(const PlaneArray& planes, const PlaneStyle& style) {
  outlines_->clear();
  const auto is_empty = [](const Plane& plane) { return plane.outline.points.empty(); };
  if (!style.outlines || std::all_of(planes.planes.begin(), planes.planes.end(), is_empty)) return;
  outlines_->begin(material_, Ogre::RenderOperation::OT_LINE_LIST, resource_group);
  for (const Plane& plane : planes.planes) {
    const Ogre::ColourValue color = toOgre(colorOf(plane, style.color_by), 1.0F);
    addRing(*outlines_, plane.outline, color);
    for (const geometry_msgs::Polygon& ring : plane.other_parts) addRing(*outlines_, ring, color);
    for (const geometry_msgs::Polygon& ring : plane.holes) addRing(*outlines_, ring, color);
  }
  outlines_->end();
}

void PlaneArrayVisual::addNormal(const Plane& plane, const PlaneStyle& style) {
  const float length = style.normal_length;
  auto arrow = std::make_unique<rviz::Arrow>(&scene_manager_, node_, 0.75F * length, 0.06F * length,
                                             0.25F * length, 0.15F * length);
  const Color color = colorOf(plane, style.color_by);
  arrow->setColor(toOgre(color, 1.0F));
  arrow->setPosition(toOgre(plane.centroid));
  arrow->setDirection(normalOf(plane));
  normals_.push_back(std::move(arrow));
}

void PlaneArrayVisual::addText(const Plane& plane, const PlaneStyle& style) {
  const float height = std::clamp(0.12F * std::sqrt(plane.area), 0.03F, 0.12F);
  auto text = std::make_unique<rviz::MovableText>(std::to_string(plane.id), "Liberation Sans", height,
                                                  Ogre::ColourValue::White);
  text->setTextAlignment(rviz::MovableText::H_CENTER, rviz::MovableText::V_CENTER);
  // In front of the arrow's tip, or just above the surface.
  const float distance = style.normals ? style.normal_length + height : height;
  Ogre::SceneNode* node = node_->createChildSceneNode(toOgre(plane.centroid) + distance * normalOf(plane));
  node->attachObject(text.get());
  text_nodes_.push_back(node);
  texts_.push_back(std::move(text));
}

}  // namespace line_plane_segmentation
