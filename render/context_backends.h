#pragma once

/// The two ways to a software GL context. Each throws EnvironmentError when its way is barred; neither tests what it
/// made, make_context does.

#include "render/context.h"

namespace proofreel {

/// Mesa's off-screen library, gone from Mesa 25.1 on.
std::unique_ptr<GlContext> make_osmesa_context();

/// EGL on Mesa's surfaceless platform, with software rendering forced.
std::unique_ptr<GlContext> make_egl_context();

}  // namespace proofreel
