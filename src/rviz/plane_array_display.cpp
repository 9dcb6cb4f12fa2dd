// SPDX-License-Identifier: BSD-3-Clause
#include "plane_array_display.h"

#include <OgreSceneNode.h>
#include <rviz/display_context.h>
#include <rviz/frame_manager.h>
#include <rviz/properties/bool_property.h>
#include <rviz/properties/enum_property.h>
#include <rviz/properties/float_property.h>

#include <algorithm>
#include <cmath>
#include <pluginlib/class_list_macros.hpp>

namespace line_plane_segmentation {
namespace {

using rviz::StatusProperty;

bool isFinite(const Plane& plane) {
  const auto& coef = plane.coefficients.coef;
  return std::all_of(coef.begin(), coef.end(), [](double value) { return std::isfinite(value); }) &&
         std::isfinite(plane.centroid.x) && std::isfinite(plane.centroid.y) &&
         std::isfinite(plane.centroid.z) && std::hypot(coef[0], coef[1], coef[2]) > 0.5;
}

}  // namespace

PlaneArrayDisplay::PlaneArrayDisplay() {
  color_by_ =
      new rviz::EnumProperty("Color By", "Id", "What the colour of a plane shows.", this, SLOT(redraw()));
  color_by_->addOption("Id", static_cast<int>(ColorBy::kId));
  color_by_->addOption("Orientation", static_cast<int>(ColorBy::kOrientation));
  color_by_->addOption("Area", static_cast<int>(ColorBy::kArea));
  const PlaneStyle defaults;
  alpha_ = new rviz::FloatProperty("Alpha", defaults.alpha, "Opacity of the surfaces: 0 invisible, 1 opaque.",
                                   this, SLOT(redraw()));
  alpha_->setMin(0.0F);
  alpha_->setMax(1.0F);
  fill_ = new rviz::BoolProperty("Fill", defaults.fill, "Draws the surfaces, without their holes.", this,
                                 SLOT(redraw()));
  outlines_ = new rviz::BoolProperty("Outlines", defaults.outlines, "Draws the borders of parts and holes.",
                                     this, SLOT(redraw()));
  normals_ = new rviz::BoolProperty("Normals", defaults.normals, "Draws an arrow along each normal.", this,
                                    SLOT(redraw()));
  normal_length_ = new rviz::FloatProperty("Normal Length", defaults.normal_length,
                                           "Length of the arrows [m].", this, SLOT(redraw()));
  normal_length_->setMin(0.001F);
  ids_ = new rviz::BoolProperty("Ids", defaults.ids, "Writes the id of each plane.", this, SLOT(redraw()));
  covariance_ = new rviz::BoolProperty(
      "Covariance", defaults.covariance,
      "Draws the uncertainty of each normal as a disc at the tip of its arrow.", this, SLOT(redraw()));
  covariance_scale_ =
      new rviz::FloatProperty("Covariance Scale", defaults.covariance_scale,
                              "Radius of the disc in standard deviations.", this, SLOT(redraw()));
  covariance_scale_->setMin(0.0F);
}

PlaneArrayDisplay::~PlaneArrayDisplay() = default;

void PlaneArrayDisplay::onInitialize() {
  MFDClass::onInitialize();
  visual_ = std::make_unique<PlaneArrayVisual>(*context_->getSceneManager(), *scene_node_);
}

void PlaneArrayDisplay::reset() {
  MFDClass::reset();
  message_.reset();
  if (visual_) visual_->draw(PlaneArray(), style());
}

PlaneStyle PlaneArrayDisplay::style() const {
  PlaneStyle style;
  style.color_by = static_cast<ColorBy>(color_by_->getOptionInt());
  style.alpha = alpha_->getFloat();
  style.fill = fill_->getBool();
  style.outlines = outlines_->getBool();
  style.normals = normals_->getBool();
  style.normal_length = normal_length_->getFloat();
  style.ids = ids_->getBool();
  style.covariance = covariance_->getBool();
  style.covariance_scale = covariance_scale_->getFloat();
  return style;
}

void PlaneArrayDisplay::redraw() {
  if (!visual_ || !message_) return;
  visual_->draw(*message_, style());
  context_->queueRender();
}

void PlaneArrayDisplay::processMessage(const PlaneArray::ConstPtr& message) {
  Ogre::Vector3 position;
  Ogre::Quaternion orientation;
  if (!context_->getFrameManager()->getTransform(message->header, position, orientation)) {
    setStatus(StatusProperty::Error, "Planes",
              QString("No transform from ") + QString::fromStdString(message->header.frame_id) + " to " +
                  fixed_frame_);
    return;
  }
  if (!std::all_of(message->planes.begin(), message->planes.end(), isFinite)) {
    setStatus(StatusProperty::Error, "Planes",
              "A plane has coefficients that are not finite: nothing is drawn");
    return;
  }
  message_ = message;
  visual_->setPose(position, orientation);
  visual_->draw(*message_, style());
  const double fraction =
      message->valid_pixels == 0 ? 0.0 : 100.0 * message->assigned_pixels / message->valid_pixels;
  setStatus(StatusProperty::Ok, "Planes",
            QString("%1 planes, %2 % of the valid pixels, %3 ms")
                .arg(message->planes.size())
                .arg(fraction, 0, 'f', 0)
                .arg(static_cast<double>(message->processing_time), 0, 'f', 1));
}

}  // namespace line_plane_segmentation

PLUGINLIB_EXPORT_CLASS(line_plane_segmentation::PlaneArrayDisplay, rviz::Display)
