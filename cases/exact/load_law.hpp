// What a pressure on a deformed interface means to a solid in its reference frame: the traction per reference area on
// the reference normal is −(p − p_e) a n, n the deformed unit normal, with a = (current area)/(reference area) (Nanson)
// or a =
// 1. The two differ by O(strain), and so do the exact solutions.
#pragma once

namespace mortise {

enum class LoadLaw {
  current_area,   // a = A_now/A_reference: force = pressure × the area it acts on
  reference_area  // a = 1
};

}  // namespace mortise
