#include "mortise/cases/driver/agreement.hpp"

#include <filesystem>
#include <new>
#include <vector>

#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

struct Failure {
  int status = 0;
  std::string sentence;
};

Failure failure_of(const std::function<void()>& action) {
  try {
    action();
    return {};
  } catch (const InputError& error) {
    return {2, error.what()};
  } catch (const EnvironmentError& error) {
    return {4, error.what()};
  } catch (const std::filesystem::filesystem_error& error) {
    return {4, error.what()};
  } catch (const std::bad_alloc&) {
    return {4, "out of memory"};
  }
}

}  // namespace

void agree(const Communicator& comm, const std::function<void()>& action) {
  Failure failure = failure_of(action);
  if (!comm.any(failure.status != 0)) return;
  const std::vector<int> statuses = comm.gather_all(std::vector<int>{failure.status});
  int first = 0;
  while (statuses[static_cast<std::size_t>(first)] == 0) ++first;
  if (comm.rank() != first) failure.sentence.clear();
  const std::vector<char> sentence =
      comm.gather_all(std::vector<char>(failure.sentence.begin(), failure.sentence.end()));
  throw AgreedFailure({sentence.begin(), sentence.end()}, statuses[static_cast<std::size_t>(first)]);
}

}  // namespace mortise
