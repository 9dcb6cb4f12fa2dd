// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Qt's moc reads this file.
#ifndef Q_MOC_RUN
#include <line_plane_segmentation/PlaneArray.h>
#include <rviz/message_filter_display.h>

#include <memory>

#include "plane_array_visual.h"
#include "plane_style.h"
#endif

namespace rviz {
class BoolProperty;
class EnumProperty;
class FloatProperty;
}  // namespace rviz

namespace line_plane_segmentation {

/// rviz display of a PlaneArray: translucent polygons with holes, outlines, normals, ids and their
/// uncertainty.
class PlaneArrayDisplay : public rviz::MessageFilterDisplay<PlaneArray> {
  Q_OBJECT

 public:
  PlaneArrayDisplay();
  ~PlaneArrayDisplay() override;

 protected:
  void onInitialize() override;
  void reset() override;

 private Q_SLOTS:
  void redraw();

 private:
  void processMessage(const PlaneArray::ConstPtr& message) override;
  PlaneStyle style() const;

  // Owned by the display's tree of properties.
  rviz::EnumProperty* color_by_;
  rviz::FloatProperty* alpha_;
  rviz::BoolProperty* fill_;
  rviz::BoolProperty* outlines_;
  rviz::BoolProperty* normals_;
  rviz::FloatProperty* normal_length_;
  rviz::BoolProperty* ids_;
  rviz::BoolProperty* covariance_;
  rviz::FloatProperty* covariance_scale_;

  std::unique_ptr<PlaneArrayVisual> visual_;
  PlaneArray::ConstPtr message_;  // that is drawn
};

}  // namespace line_plane_segmentation
