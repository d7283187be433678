#include "mortise/cases/study/scheme_variant.hpp"

#include <algorithm>

#include "mortise/cases/input/options.hpp"
#include "mortise/grids/core/error.hpp"
#include "mortise/grids/core/registry.hpp"

namespace mortise {
namespace {

const Registry<const char*>& variants() {
  static const Registry<const char*> registry("variant", {{"substeps", "coupling.substeps=true"},
                                                          {"lagged", "coupling.wall_velocity=lagged"},
                                                          {"linear", "coupling.fsrp=linear"}});
  return registry;
}

bool has_interfaces(const CaseDescription& scene) {
  return scene.has_gas &&
         std::any_of(scene.solids.begin(), scene.solids.end(), [](const SolidDescription& s) { return s.wet(); });
}

/// What scene/mapped_solids.cpp takes.
bool can_be_mapped(const CaseDescription& scene) {
  return scene.bodies.empty() && scene.riemann == "hllc" &&
         std::all_of(scene.solids.begin(), scene.solids.end(), [](const SolidDescription& s) {
           return s.immersed() && s.wet() && s.gas != "inside" && s.material.law != "linear";
         });
}

}  // namespace

std::vector<std::string> split_list(const std::string& text, const std::string& option) {
  std::vector<std::string> parts;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(',', start), text.size());
    parts.push_back(text.substr(start, end - start));
    if (parts.back().empty()) throw InputError(option + " " + text + ": an entry of the list is empty");
    start = end + 1;
  }
  return parts;
}

SchemeVariant scheme_variant(const std::string& name, const CaseDescription& scene) {
  SchemeVariant variant{name, {}};
  const std::size_t plus = name.find('+');
  const std::string scheme = name.substr(0, plus);
  const bool interfaces = has_interfaces(scene);
  const std::vector<std::string>& known = interfaces ? options::interface_schemes : options::body_schemes;
  if (std::count(known.begin(), known.end(), scheme) == 0) {
    const std::string guess = nearest(scheme, known);
    throw InputError("--schemes " + name + ": the scheme \"" + scheme + "\" cannot run this scene" +
                     (guess.empty() ? "" : ", did you mean \"" + guess + "\"?") + " (those that can: " + joined(known) +
                     ")");
  }
  variant.overrides.push_back("scheme=" + scheme);
  if (interfaces) variant.overrides.push_back("coupling.substeps=false");
  if (plus == std::string::npos) return variant;
  if (!interfaces) throw InputError("--schemes " + name + ": the schemes of rigid bodies have no variants");
  std::string rest = name.substr(plus + 1);
  std::replace(rest.begin(), rest.end(), '+', ',');
  for (const std::string& word : split_list(rest, "--schemes " + name + ":"))
    variant.overrides.push_back(variants().at(word));
  return variant;
}

std::vector<SchemeVariant> scheme_variants(const std::string& names, const CaseDescription& scene) {
  std::vector<SchemeVariant> all;
  for (const std::string& name : split_list(names, "--schemes")) all.push_back(scheme_variant(name, scene));
  return all;
}

std::string default_schemes(const CaseDescription& scene, bool all) {
  if (has_interfaces(scene))
    return std::string("projection,projection+substeps,traditional,traditional-subiterated") +
           (all                    ? ",traditional+lagged,anti-traditional,anti-traditional+lagged"
            : can_be_mapped(scene) ? ",reference-map"
                                   : "");
  if (!scene.bodies.empty()) return "rigid,traditional";
  throw InputError("the case \"" + scene.name + "\" couples nothing: it has neither bodies nor solids beside gas");
}

}  // namespace mortise
