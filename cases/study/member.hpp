// The members of a study: runs of one case with changed keys, each in a directory of its own.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "mortise/cases/input/case_description.hpp"
#include "mortise/cases/study/task_pool.hpp"
#include "mortise/cases/summary/summary.hpp"
#include "mortise/grids/output/snapshot.hpp"

namespace mortise {

/// What all studies are told.
struct StudyOptions {
  std::string case_name;               // name or path of the case
  std::vector<std::string> overrides;  // "key=value" for all members
  std::string cases_root;              // where shipped cases are
  std::string output;                  // directory; empty: output/<study>_<case>
  int jobs = 0;                        // processes at a time; 0: all cores
  bool quiet = false;                  // no progress
};

/// One run.
struct Member {
  std::string name;                    // of its directory
  std::string case_name;               // name or path
  std::vector<std::string> overrides;  // "key=value" each
  bool keep_fields = false;            // its last fields are wanted
  double weight = 1;                   // expected cost, in any unit
};

/// What it came to; numbers are those of its summary.json.
struct MemberResult {
  std::string status;  // finished, unstable, failed; crashed: the process did not end by itself
  std::string reason;  // when not finished
  double time = 0;     // reached
  double steps = 0;
  double seconds = 0;  // of the time loop, without writing files
  double cell_updates = 0;
  std::map<std::string, ErrorNorms> errors;
  std::string directory;
  bool finished() const { return status == "finished"; }
};

/// Reads and checks every member before anything runs. Throws InputError.
std::vector<CaseDescription> check_members(const std::vector<Member>& members, const std::string& cases_root);
/// Builds the scene as well, and cuts its first overlap. Throws InputError.
void check_scene(const CaseDescription& description);

/// Runs them below options.output/members, the most expensive first or, `interleave`, in their order; results in their
/// order. Throws InputError for a member that was refused although its case reads well, EnvironmentError for one that
/// failed for want of disk or memory.
std::vector<MemberResult> run_members(const std::vector<Member>& members, const StudyOptions& options,
                                      bool interleave = false);

/// The last fields of a member that keeps them. Throws EnvironmentError.
Snapshot last_fields(const MemberResult& result);

/// "key=value", the text a case file would have.
std::string override_of(const std::string& key, double value);

}  // namespace mortise
