#pragma once

#include <string>

#include "photo/image.h"
#include "photo/photo_deck.h"

namespace repose::photo {

/// The picture in `bytes` (JPEG, PNG or TIFF) as a person sees it: turned as its EXIF or TIFF orientation says. `name`
/// is for messages. FileError when it is no such picture, damaged or cut off, or has more than 400 million pixels.
Image read_photo(const std::string& bytes, const std::string& name, Channel channel);

/// A PNG of the picture. FileError when there is no memory for it.
std::string png_of(const Image& image);

}  // namespace repose::photo
