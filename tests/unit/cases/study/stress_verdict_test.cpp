// Verdicts on made-up endings and summaries.
#include "mortise/cases/study/stress_verdict.hpp"

#include <gtest/gtest.h>

#include <csignal>

#include "unit/cases/input/scratch_case.hpp"

namespace mortise {
namespace {

const std::string good =
    R"({"status": "finished", "reason": "", "time": 0.5, "steps": 12, "bodies": [{"name": "b", "position": [0.5, 1], "angle": 0.0}],
        "conservation": {"mass": 0.0, "momentum": null, "energy": null}, "overlap": {"orphans": 0, "fringe": 4}})";

Verdict of(const RunEnding& ending, const std::string& summary = good) { return judge_run(ending, summary).verdict; }

const RunEnding finished{};

TEST(StressVerdict, PassesWhatFinishedWithNumbers) {
  EXPECT_EQ(of(finished), Verdict::passed);
  EXPECT_EQ(judge_run(finished, good).reason, "");
}

TEST(StressVerdict, KnowsTheProgramsStatuses) {
  EXPECT_EQ(of({.status = 2}), Verdict::refused);
  EXPECT_EQ(of({.status = 3}), Verdict::numerical);
  EXPECT_EQ(of({.status = 3}, ""), Verdict::numerical);
  EXPECT_EQ(judge_run({.status = 3}, R"({"reason": "the coupling is unstable"})").reason, "the coupling is unstable");
  for (const int status : {1, 4, 127, 134}) EXPECT_EQ(of({.status = status}), Verdict::crash) << status;
}

TEST(StressVerdict, KnowsCrashesAndHangs) {
  EXPECT_EQ(of({.signal = SIGSEGV}), Verdict::crash);
  EXPECT_NE(judge_run({.signal = SIGSEGV}, "").reason.find("11"), std::string::npos);
  EXPECT_EQ(of({.timed_out = true, .signal = SIGKILL}), Verdict::hang);
}

TEST(StressVerdict, FindsLies) {
  EXPECT_EQ(of(finished, ""), Verdict::lied);
  EXPECT_EQ(of(finished, "{"), Verdict::lied);
  EXPECT_EQ(of(finished, test::with(good, "finished", "unstable")), Verdict::lied);
  const Judgement bad = judge_run(finished, test::with(good, "[0.5, 1]", "[0.5, null]"));
  EXPECT_EQ(bad.verdict, Verdict::lied);
  EXPECT_EQ(bad.reason, "not a finite number: bodies.0.position.1");
  EXPECT_EQ(of(finished, test::with(good, "\"mass\": 0.0", "\"mass\": null")), Verdict::lied);
  EXPECT_EQ(of(finished, test::with(good, "\"time\": 0.5", "\"time\": 1e999")), Verdict::lied);
  EXPECT_EQ(of(finished, test::with(good, "\"overlap\"", "\"under\"")), Verdict::lied);
}

TEST(StressVerdict, CountsOrphans) {
  const Judgement orphans = judge_run(finished, test::with(good, "\"orphans\": 0", "\"orphans\": 3"));
  EXPECT_EQ(orphans.verdict, Verdict::orphans);
  EXPECT_EQ(orphans.reason, "3 cells at the overlap without a donor");
}

TEST(StressVerdict, LooksAtTheLastRowsOfHistories) {
  const test::Scratch scratch;
  scratch.write("summary.json", good);
  const std::string folder = scratch.folder().string(), header = "t,body,x\n0,b,nan\n";
  scratch.write("bodies.csv", header + "0.5,b,1.5\n");
  EXPECT_EQ(judge_run_in(finished, folder).verdict, Verdict::passed);
  scratch.write("interface.csv", header + "0.5,b,-inf\n");
  EXPECT_EQ(judge_run_in(finished, folder).verdict, Verdict::lied);
  scratch.write("interface.csv", header + "0.5,b,2\n");
  scratch.write("bodies.csv", header + "0.5,b,nan\n");
  EXPECT_EQ(judge_run_in(finished, folder).reason, "not a finite number in the last row of bodies.csv");
  EXPECT_EQ(judge_run_in({.status = 3}, folder).verdict, Verdict::numerical);
}

TEST(StressVerdict, HasAWordForEach) {
  ASSERT_EQ(verdicts().size(), 7u);
  for (const Verdict verdict : verdicts())
    EXPECT_EQ(acceptable(verdict), verdict <= Verdict::numerical) << name_of(verdict);
  EXPECT_STREQ(name_of(Verdict::passed), "passed");
  EXPECT_STREQ(name_of(Verdict::orphans), "orphans");
}

}  // namespace
}  // namespace mortise
