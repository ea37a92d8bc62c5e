// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnSurfaceRender_h
#define gtnSurfaceRender_h

// gtn render for surfaces, which OpenGL draws.

#include "gtnRenderOptions.h"
#include "gtnSettings.h"

namespace gtn
{
/** Renders and writes all images of a surface. Throws Failure, for example without a display. */
void RenderSurface(const RenderOptions& options, const Settings& settings);
}

#endif
