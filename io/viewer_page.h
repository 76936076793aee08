#pragma once

#include <string_view>

namespace tetsculpt {

/// The page of the viewer, made of the files in io/viewer when the library is built. In it stand
/// {{title}} (twice), {{facts}} and {{data}} for what io/viewer_writer puts there.
extern const std::string_view kViewerPage;

}  // namespace tetsculpt
