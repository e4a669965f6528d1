#pragma once
// What the lecture's demo of convergence shows (./lab demo): point sets of the plane at every size,
// what they make of the demo's integrands, and their error over many sets. A lab's hidden case,
// tagged [.demo], writes those of its point sets.

#include <string>

#include "measurements/support/methods.hpp"

namespace mc::measurements {

/// Writes demo-`place`-KEY.json: the method's points at 1, 2, 4, … min(4096, `most`), its
/// estimates, its errors. Nothing where the task is not written. Pages show methods in the order of
/// their places.
void write_demo(int place, const Method& method);

}  // namespace mc::measurements
