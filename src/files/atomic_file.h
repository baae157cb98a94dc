#pragma once

#include <string>
#include <string_view>

namespace repose {

/// The name beside `path` under which a file is written until it is complete.
std::string partial_path(const std::string& path);

/// Throws FileError when `path` is something else than a regular file: a rename would replace a device as readily.
void refuse_special_file(const std::string& path);

/// Makes the complete file at partial_path(path) appear as `path`: synced, renamed, the folder synced. Throws FileError
/// with the path and the system's reason; then the partial file stays.
void publish_file(const std::string& path);

/// Removes the partial file of `path` if there is one; never throws.
void discard_partial_file(const std::string& path) noexcept;

/// Writes `text` to `path` whole or not at all, whenever the process is killed. Throws FileError with the path and the
/// system's reason; then a previous file is untouched and nothing is left beside it.
void write_text_file(const std::string& path, std::string_view text);

}  // namespace repose
