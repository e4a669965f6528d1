#pragma once
// All scenes.

#include "common/scenes/ao_sphere.hpp"
#include "common/scenes/ao_wall.hpp"
#include "common/scenes/defocus_edge.hpp"
#include "common/scenes/disk_light.hpp"
#include "common/scenes/motion_edge.hpp"
#include "common/scenes/penumbra_disk.hpp"
#include "common/scenes/penumbra_halfplane.hpp"
#include "common/scenes/pixel_edge.hpp"
#include "common/scenes/pixel_time_lens.hpp"
#include "common/scenes/rect_light.hpp"
#include "common/scenes/rect_light_horizon.hpp"
#include "common/scenes/sphere_light.hpp"
#include "common/scenes/stripes.hpp"
