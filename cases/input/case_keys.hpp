// Every key of a case file: name, type, range, default and meaning.
#pragma once

#include "mortise/cases/input/case_description.hpp"
#include "mortise/cases/input/section.hpp"

namespace mortise {

/// Reads the table of a whole case file into `description`, or lists its keys (see Section). What a single key must
/// satisfy is checked here; what keys must satisfy together is checked by check_case.
void visit_case(Section& file, CaseDescription& description);

/// All keys, in the order in which people write them.
std::vector<KeyEntry> all_keys();

}  // namespace mortise
