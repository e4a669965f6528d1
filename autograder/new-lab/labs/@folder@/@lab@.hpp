#pragma once
// Lab @number@ · @title@: what to write. Every function belongs to the task that its comment names.

namespace mc {

/// @number@.1  The square of x, rounded once.
/// requires: any x; NaN gives NaN.
double square(double x);

}  // namespace mc
