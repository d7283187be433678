#include "mortise/cases/driver/list.hpp"

#include <cstdio>
#include <functional>

#include "mortise/cases/input/case_file.hpp"
#include "mortise/cases/input/options.hpp"
#include "mortise/grids/core/registry.hpp"

namespace mortise {

void list_options(const std::string& what, const std::string& cases_root) {
  using Names = std::function<std::vector<std::string>()>;
  const Registry<Names> kinds("list", {{"cases", [&] { return case_names(cases_root); }},
                                       {"schemes", [] { return options::schemes; }},
                                       {"riemann", [] { return options::riemann_solvers; }},
                                       {"limiters", [] { return options::limiters; }},
                                       {"materials", [] { return options::laws; }},
                                       {"shapes", [] { return options::shapes; }},
                                       {"solids", [] { return options::solid_shapes; }},
                                       {"sides", [] { return options::solid_sides; }},
                                       {"boundaries", [] { return options::boundaries; }},
                                       {"initial", [] { return options::initial_kinds; }},
                                       {"exact", [] { return options::exact_solutions; }},
                                       {"pictures", [] { return options::pictures; }},
                                       {"keys", [] { return std::vector<std::string>{describe_keys()}; }}});
  if (what.empty()) {
    for (const std::string& kind : kinds.keys())
      if (kind != "keys") std::printf("%-11s %s\n", kind.c_str(), joined(kinds.at(kind)()).c_str());
    return;
  }
  for (const std::string& name : kinds.at(what)()) std::printf("%s\n", name.c_str());
}

}  // namespace mortise
