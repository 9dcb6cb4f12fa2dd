// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include <typeinfo>

namespace line_plane_segmentation {

/// Converts Python objects to references to a bound class, if __init__() or __setstate__() was called on
/// them. An object that was made with __new__ alone has no C++ object: pybind11's own conversion would
/// allocate memory for one and not construct it. A specialisation of pybind11::detail::type_caster for the
/// class derives from this class, before any use.
template <typename Class>
class InitialisedCaster : public pybind11::detail::type_caster_base<Class> {
 public:
  /// @throws pybind11::type_error if the object is of the class, but was not initialised
  bool load(pybind11::handle source, bool convert) {
    if (pybind11::isinstance<Class>(source)) {
      auto* const instance = reinterpret_cast<pybind11::detail::instance*>(source.ptr());
      const auto* const type = pybind11::detail::get_type_info(typeid(Class));
      if (!instance->get_value_and_holder(type)) {
        throw pybind11::type_error("this is not an object on which __init__() was called");
      }
    }
    return pybind11::detail::type_caster_base<Class>::load(source, convert);
  }
};

}  // namespace line_plane_segmentation
