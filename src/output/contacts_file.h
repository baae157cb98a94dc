#pragma once

#include <span>
#include <string>

#include "measurement/contact_list.h"

namespace repose {

/// Contacts as PolyData of VTK (.vtp): a line each from the centre of the first particle to that of the second or to
/// the touched point of the wall, with ids, wall and forces as arrays of cells.
std::string contacts_text(std::span<const ListedContact> contacts, double time_s);

}  // namespace repose
