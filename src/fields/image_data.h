#pragma once

#include <string>

#include "fields/coarse_grain.h"

namespace repose::fields {

/// What the file says beside the fields.
struct FieldsHead {
  double time = 0.0;           ///< s
  double width = 0.0;          ///< m, half-width of the kernel
  std::string contact_forces;  ///< of which the contact stress is: "normal" or "normal and tangential"
};

/// Image data of VTK (.vti) with the fields as arrays of cells.
std::string image_data(const Fields& fields, const FieldsHead& head);

}  // namespace repose::fields
