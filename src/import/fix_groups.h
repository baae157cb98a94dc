#pragma once

#include "import/imported_scene.h"

namespace repose {

/// As a run begins, what the groups of the fixes mean that are there: before the first one, which grains of the list
/// stand still, since a fix freezes them or none moves them; and notes of what acts on some grains there, on all here.
void settle_groups(ImportedScene& scene);

}  // namespace repose
