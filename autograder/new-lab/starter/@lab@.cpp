// Lab @number@ · @title@. labs/@folder@/@lab@.hpp states what each function promises, and
// labs/@folder@/README.md is the handout.

#include "@lab@.hpp"

#include "common/todo.hpp"

namespace mc {

double square(double x) {
  throw todo("@number@.1");  // TODO(@number@.1): x times x
}

}  // namespace mc
