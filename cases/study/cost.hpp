// `mortise study cost`: run time against error, for every scheme that can run the scene.
#pragma once

#include <string>
#include <vector>

#include "mortise/cases/study/convergence.hpp"

namespace mortise {

struct CostOptions : StudyOptions {
  std::string vary = "grid.factor";
  int levels = 3;
  std::string schemes;   // "a,b,c"; empty: default_schemes()
  std::string limiters;  // of the gas; empty: the case's
  std::string cfls;      // empty: the case's
  int repeats = 3;
  std::string against;   // exact, self (a run of the first scheme with twice the finest resolution); empty: as there is
  std::string quantity;  // the error of this one counts; empty: of all of the gas and the solids
};

/// One configuration at one resolution.
struct CostPoint {
  std::string scheme, limiter, cfl;
  double value = 0;  // of what varies
  std::string status;
  double error = 0;    // L1, relative (cost.cpp)
  double seconds = 0;  // median
  double least = 0, most = 0;
  double cell_updates = 0;
  bool on_front = false;  // no other point has less error in less time
};

/// Marks the points that are not dominated, among those that finished.
void mark_pareto_front(std::vector<CostPoint>& points);

/// Seconds a curve (errors falling with time) needs for an error, interpolated in logarithms; NaN outside its range.
double seconds_for(std::vector<CostPoint> curve, double error);

/// Throws InputError before anything runs.
int study_cost(CostOptions options);

}  // namespace mortise
