#pragma once
// Everything that a check may use. Each file of a lab's checks, and each source beside this header,
// may rely on all of it.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "checks/support/battery.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/compare.hpp"
#include "checks/support/distributions.hpp"
#include "checks/support/domain.hpp"
#include "checks/support/exact.hpp"
#include "checks/support/inversions.hpp"
#include "checks/support/measure.hpp"
#include "checks/support/refusals.hpp"
#include "checks/support/sample_sets.hpp"
#include "checks/support/statistics.hpp"
#include "checks/support/strata.hpp"
#include "common/points.hpp"
#include "common/rng.hpp"
