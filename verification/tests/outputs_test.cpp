// Where outputs go: no input is lost, devices, pipes and links stay what they are, and what cannot
// be written is said.
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <boost/algorithm/string/replace.hpp>
#include <cmath>
#include <functional>

#include "verification/files/content_hash.hpp"
#include "verification/results/result_file.hpp"
#include "verification/tests/small_campaign.hpp"

namespace slosh::outputs_test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

// A command whose output goes to the place. Where it writes into a directory, `file` is the one
// there that goes to the place.
struct Output {
  Output(const char* name, const std::string& line, const char* file, const char* ending,
         const std::string& inputs)
      : name(name), words(words_of(line)), file(file), ending(ending), inputs(words_of(inputs)) {}
  const char* name;
  Words words;  // "PLACE" stands for the place, or for the directory
  std::string file, ending;
  Words inputs;
};

const std::string of_case = "small.toml motion.csv", of_study = of_case + " wave.csv solve version",
                  of_campaign = of_study + " surges.toml ledger.jsonl ledger.jsonl.head";
const std::string gate = "gate ./surges.toml --ledger ledger.jsonl -o PLACE";

const std::vector<Output>& outputs() {
  static const std::vector<Output> all{
      {"export", "export theory.h5 --csv -o PLACE", "", "", "theory.h5"},
      {"compare", "compare theory.h5 mine.h5 --case ./small.toml --gauge right --json PLACE", "",
       "", "theory.h5 mine.h5 small.toml motion.csv"},
      {"import",
       "import wave.csv --format csv --time time --series elevation@right=elevation@right -o PLACE",
       "", "", "wave.csv"},
      {"import, of particles",
       "import particles.csv --format particles --case ./small.toml --spacing 0.1 -o PLACE", "", "",
       "particles.csv small.toml motion.csv"},
      {"export, of a case", "export ./small.toml -o PLACE", "", ".csv", of_case},
      {"run", "run ./small.toml mine -o PLACE", "", "", of_study},
      {"run --progress-file", "run ./small.toml mine -o new.h5 --progress-file PLACE", "", "",
       of_study},
      {"show", "show ./small.toml -o PLACE", "", ".svg", of_case},
      {"converge", "converge ./small.toml --family copy --spacings 0.04,0.02,0.01 -o PLACE",
       "small.toml", "", of_study},
      {"gate, its page", gate, "gate/gate.md", "", of_campaign},
      {"gate, its JUnit", gate, "gate/junit.xml", "", of_campaign},
      {"baseline propose", "baseline propose ./surges.toml --ledger ledger.jsonl -o PLACE",
       "baseline_proposal.json", "", of_campaign}};
  return all;
}

Words put(Words words, const std::string& place) {
  for (std::string& word : words) boost::replace_all(word, "PLACE", place);
  return words;
}

class Outputs : public SmallCampaign {
 protected:
  // A case with a table of motion and a program that copies theory, a campaign, its ledger, and
  // results.
  Outputs() {
    std::string motion = "time_s,displacement_m\n";
    for (int i = 0; i <= 900; ++i)
      motion += std::to_string(0.01 * i) + "," + std::to_string(0.02 * std::sin(0.03 * i)) + "\n";
    write("motion.csv", motion);
    write("solve", "#!/bin/sh\ncp \"$1\" \"$2/wave.csv\"\n");
    write("version", "#!/bin/sh\necho 1\n");
    for (const char* program : {"solve", "version"})
      fs::permissions(directory() / program, fs::perms::owner_all);
    const std::string case_text =
        with(small_case, "type = \"sine\"\namplitude_m = 0.02\nangular_frequency_rad_s = 3.0\n",
             "type = \"table\"\nfile = \"motion.csv\"\n");
    write_campaign(case_text);
    EXPECT_EQ(run("theory").status, 0);
    EXPECT_EQ(typed("export theory.h5 -o wave.csv").status, 0);
    write_campaign(case_text + program +
                   with(gate_on("mine"), "mode = \"forced\"\nmetric = \"amplitude_error\"",
                        "mode = \"whole\"\nmetric = \"normalised_rms\""));
    const Ended mine = run("mine");
    EXPECT_EQ(mine.status, 0) << mine.err;
    write("particles.csv", "time,x,z\n0,0.5,0.1\n0,0.6,0.1\n");
  }

  void begin_ledger() const {
    ASSERT_EQ(campaign().status, 0);
    const Words common = words_of("./surges.toml -o out --ledger ledger.jsonl --new");
    for (Words words :
         {Words{"baseline", "propose"}, words_of("baseline approve --who A --reason b")}) {
      words.insert(words.begin() + 2, common.begin(), common.end());
      const Ended ended = tool(words);
      ASSERT_EQ(ended.status, 0) << ended.out << ended.err;
    }
    // Something to propose.
    write("small.toml", with(read("small.toml"), "limit = 0.3", "limit = 0.29"));
  }

  // Starts the command with its output at this place, where `lay` puts what is there before.
  Ended start_at(const Output& output, const std::string& name,
                 const std::function<void(const fs::path&)>& lay) const {
    std::string place = name + output.ending;
    fs::path there = directory() / place;
    if (!output.file.empty()) {
      there = directory() / name / output.file;
      place = name;
    }
    fs::create_directories(there.parent_path());
    if (lay) lay(there);
    return tool(put(output.words, place));
  }

  fs::path place_of(const Output& output, const std::string& name) const {
    return directory() /
           (output.file.empty() ? fs::path(name + output.ending) : fs::path(name) / output.file);
  }

  static const std::string program;
};

const std::string Outputs::program = R"([[run]]
name = "mine"
solver = "external"
method = "copy"
particle_spacing_m = 0.04
command = ["./solve", "wave.csv", "{work_directory}", "{particle_spacing_m}"]
version_command = ["./version"]
directory = "."
inputs = ["wave.csv"]
[[run.series]]
quantity = "elevation@right"
file = "wave.csv"
format = "csv"
time_column = "time"
column = "elevation@right"
)";

TEST_F(Outputs, ReplaceNoInputByItsNameOrByALink) {
  begin_ledger();
  int count = 0;
  for (const Output& output : outputs())
    for (const std::string& input : output.inputs) {
      const fs::path file = directory() / input;
      const std::string before = read(input);
      const auto expect_refused = [&](const char* way, const Ended& ended) {
        SCOPED_TRACE(std::string(output.name) + " onto " + input + ", " + way);
        EXPECT_EQ(ended.status, 2) << ended.out << ended.err;
        EXPECT_TRUE(holds(ended.err, "is an input of this command and would be lost"));
        EXPECT_EQ(read(input), before);
        write(input, before);
      };
      const std::string name = "place_" + std::to_string(++count);
      expect_refused("a symbolic link", start_at(output, name, [&](const fs::path& there) {
                       fs::create_symlink(file, there);
                     }));
      EXPECT_TRUE(fs::is_symlink(place_of(output, name)));
      expect_refused("a hard link", start_at(output, name + "h", [&](const fs::path& there) {
                       fs::create_hard_link(file, there);
                     }));
      if (output.file.empty() && input.ends_with(output.ending))
        expect_refused("its own name", tool(put(output.words, input)));
    }
}

TEST_F(Outputs, OfAStudyReplaceItsOwnFilesAndNoOther) {
  Words study = put(outputs()[8].words, "study");
  ASSERT_EQ(study.front(), "converge");
  EXPECT_NE(tool(study).status, 2);
  const std::string made = read("study/small.toml"), table = read("study/motion.csv");
  EXPECT_FALSE(holds(tool(study).err, ".slosh"));
  EXPECT_EQ(read("study/small.toml"), made);
  for (const auto& [file, text] : {std::pair{"small.toml", made}, {"motion.csv", table}}) {
    write(std::string("study/") + file, "a week of work");
    const std::string kept = file + std::string(".kept-1");
    EXPECT_TRUE(holds(tool(study).err, "it is kept as " + kept));
    EXPECT_EQ(read("study/" + kept), "a week of work");
    EXPECT_EQ(read(std::string("study/") + file), text);
  }
}

TEST_F(Outputs, RemoveNoDirectoryOfAUsersFromThatOfTheJobs) {
  fs::create_directories(directory() / "out/jobs/list_of_mine");
  write("out/jobs/list_of_mine/notes.txt", "a week of work");
  EXPECT_EQ(campaign().status, 0);
  EXPECT_EQ(read("out/jobs/list_of_mine/notes.txt"), "a week of work");
}

TEST_F(Outputs, ReplaceNoInputThatLiesInADirectoryOfTheTool) {
  const Words report = words_of("campaign --report-only ./out/report/tables/surges.toml -o out");
  fs::create_directories(directory() / "out/report/tables");
  fs::copy_file(directory() / "surges.toml", directory() / "out/report/tables/surges.toml");
  fs::copy_file(directory() / "small.toml", directory() / "out/report/tables/small.toml");
  for (const char* file : {"motion.csv", "wave.csv", "solve", "version"})
    fs::copy_file(directory() / file, directory() / "out/report/tables" / file);
  const Ended reported = tool(report);
  EXPECT_EQ(reported.status, 2) << reported.out << reported.err;
  EXPECT_TRUE(holds(reported.err, "is an input of this command and would be lost"));
  EXPECT_TRUE(fs::exists(directory() / "out/report/tables/surges.toml"));

  fs::create_directory(directory() / "new.work");
  fs::rename(directory() / "out/report/tables", directory() / "new.work/mine.external");
  const Ended ran = typed("run ./new.work/mine.external/small.toml mine -o new.h5");
  EXPECT_EQ(ran.status, 0) << ran.out << ran.err;
  EXPECT_TRUE(holds(ran.err, "the program works in mine.external-2"));
  EXPECT_TRUE(fs::exists(directory() / "new.work/mine.external/small.toml"));
}

TEST_F(Outputs, OfACampaignReplaceNoInputOfAProgramThatLiesInTheReport) {
  fs::create_directories(directory() / "out/report/tables");
  fs::copy_file(directory() / "wave.csv", directory() / "out/report/tables/own.csv");
  write("small.toml", with(read("small.toml"), "inputs = [\"wave.csv\"]",
                           "inputs = [\"wave.csv\", \"out/report/tables/own.csv\"]"));
  const Ended ended = campaign();
  EXPECT_EQ(ended.status, 2) << ended.out << ended.err;
  EXPECT_EQ(read("out/report/tables/own.csv"), read("wave.csv"));
}

TEST_F(Outputs, WaitForNoReaderOfTheCosts) {
  fs::create_directories(store());
  fs::remove(store() / "costs.txt");
  ASSERT_EQ(::mkfifo((store() / "costs.txt").c_str(), 0600), 0);
  EXPECT_EQ(campaign().status, 0);
  EXPECT_TRUE(fs::is_fifo(store() / "costs.txt"));
}

TEST_F(Outputs, FollowTheLinksThatAUserNamesAndNoOthers) {
  for (const Output& output : outputs()) {
    if (output.name == std::string("run --progress-file")) continue;
    SCOPED_TRACE(output.name);
    if (output.name == std::string("gate, its page")) begin_ledger();
    const std::string name = "linked_" + std::to_string(&output - outputs().data());
    const std::string target = name + ".target";
    const Ended ended = start_at(output, name, [&](const fs::path& there) {
      fs::create_symlink(directory() / target, there);
    });
    const bool is_named = output.file.empty();
    EXPECT_EQ(ended.status, is_named ? 0 : 4) << ended.err;
    EXPECT_TRUE(fs::is_symlink(place_of(output, name)));
    EXPECT_EQ(fs::exists(directory() / target), is_named);
    EXPECT_EQ(holds(ended.err, "by its list .slosh"), !is_named) << ended.err;
  }
}

// Whoever proposes a change may commit links, and a list, where the outputs of a start go.
TEST_F(Outputs, LieBehindNoLinkThatWasCommitted) {
  begin_ledger();
  ASSERT_EQ(typed("gate ./surges.toml --ledger ledger.jsonl -o out").status, 0);
  const Words gate = words_of("gate ./surges.toml --ledger ledger.jsonl"),
              start{"campaign", "./surges.toml"},
              report{"campaign", "--report-only", "./surges.toml"},
              propose{"baseline", "propose", "./surges.toml", "--ledger", "ledger.jsonl"},
              mistake{"gate", "./surges.toml", "--mistake"};
  write("mine", "a week of work");
  int count = 0;
  for (const auto& [words, link] : {std::pair{gate, "gate/gate.md"},
                                    {gate, "gate/junit.xml"},
                                    {gate, "gate"},
                                    {gate, "jobs"},
                                    {gate, "runs"},
                                    {gate, "runs/small"},
                                    {start, "report"},
                                    {start, "report/index.html"},
                                    {start, "report/results.json"},
                                    {start, "report/figures"},
                                    {start, "jobs"},
                                    {start, "runs/small"},
                                    {start, "drawings"},
                                    {report, "report"},
                                    {report, "report/results.json"},
                                    {propose, "baseline_proposal.json"},
                                    {mistake, "gate/gate.md"},
                                    {mistake, "report/index.html"},
                                    {mistake, "gate"},
                                    {mistake, "report"}}) {
    SCOPED_TRACE(words.front() + ", " + link);
    const std::string place = "linked_" + std::to_string(++count), away = place + "_away";
    fs::copy(directory() / "out", directory() / place,
             fs::copy_options::recursive | fs::copy_options::copy_symlinks);
    const fs::path there = directory() / place / link;
    const bool is_directory = fs::path(link).extension().empty();
    fs::create_directories(there.parent_path());
    fs::create_directory(directory() / away);
    write(away + "/gate.md", "a week of work");
    fs::remove_all(there);
    fs::create_symlink(directory() / (is_directory ? away : "mine"), there);
    std::ofstream(there.parent_path() / ".slosh", std::ios::app)
        << content_hash("a week of work") << " " << there.filename().string() << "\n";
    Words all = words;
    for (const char* word : {"-o", place.c_str(), "--store", "another"}) all.emplace_back(word);
    if (words == report || words == propose) all.resize(all.size() - 2);
    const Ended ended = tool(all);
    EXPECT_NE(ended.status, 0) << ended.out << ended.err;
    EXPECT_TRUE(fs::is_symlink(there));
    EXPECT_EQ(read("mine"), "a week of work");
    EXPECT_EQ(read(away + "/gate.md"), "a week of work");
    EXPECT_EQ(std::distance(fs::directory_iterator(directory() / away), {}), 1);
    fs::remove_all(directory() / "another");
  }
}

// A gate's document and a proposal of a user's, with no list beside them.
TEST_F(Outputs, ReplaceNoDocumentOfAUsers) {
  begin_ledger();
  const Words end{"-o", "own"};
  for (Words words : {words_of("gate ./surges.toml --ledger ledger.jsonl"),
                      {"campaign", "./surges.toml"},
                      {"campaign", "--report-only", "./surges.toml"},
                      {"gate", "./surges.toml", "--mistake"},
                      {"baseline", "propose", "./surges.toml", "--ledger", "ledger.jsonl"}}) {
    SCOPED_TRACE(words.front());
    fs::create_directories(directory() / "own/gate");
    for (const char* file :
         {"own/gate/gate.md", "own/gate/junit.xml", "own/baseline_proposal.json"})
      write(file, "a week of work");
    words.insert(words.end(), end.begin(), end.end());
    tool(words);
    for (const std::string file :
         {"own/gate/gate.md", "own/gate/junit.xml", "own/baseline_proposal.json"}) {
      const std::string kept = fs::exists(directory() / (file + ".kept-1")) ? ".kept-1" : "";
      EXPECT_EQ(read(file + kept), "a week of work") << file;
    }
    fs::remove_all(directory() / "own");
  }
  fs::create_directory(directory() / "baselines");
  for (const char* file : {"surges.selftest.json", "baselines/surges.selftest.json"})
    write(file, "a week of work");
  EXPECT_NE(typed("gate --selftest ./surges.toml -o out --record").status, 0);
  for (const char* file : {"surges.selftest.json", "baselines/surges.selftest.json"})
    EXPECT_EQ(read(file), "a week of work") << file;
}

// No command knows the files of a case that it does not read.
TEST_F(Outputs, ThatAUserNamesReplaceWhatTheSameCommandHasLeftAlone) {
  begin_ledger();
  for (const Output& output : outputs()) {
    if (!output.file.empty()) continue;
    SCOPED_TRACE(output.name);
    const std::string place = "again_" + std::to_string(&output - outputs().data()) + output.ending;
    EXPECT_EQ(tool(put(output.words, place)).status, 0);
    EXPECT_EQ(tool(put(output.words, place)).status, 0) << "the same once more";
    for (const std::string& text : {std::string("time,surface\n0,0\n"), read("theory.h5")}) {
      write("record" + output.ending, text);
      const Ended ended = tool(put(output.words, "record" + output.ending));
      EXPECT_TRUE(ended.status == 2 || ended.status == 4) << ended.out << ended.err;
      EXPECT_TRUE(holds(ended.err, "record" + output.ending));
      EXPECT_TRUE(read("record" + output.ending) == text);
    }
  }
  ASSERT_EQ(tool(put(outputs()[2].words, "stored.h5")).status, 0);
  const std::string stored = read("stored.h5");
  EXPECT_EQ(run("theory", {"-o", "stored.h5"}).status, 4);
  EXPECT_TRUE(read("stored.h5") == stored);
}

// A device of the test's own, with the numbers of /dev/null or /dev/full.
bool make_device(const fs::path& file, unsigned number) {
  return ::mknod(file.c_str(), S_IFCHR | 0666, makedev(1, number)) == 0;
}

bool is_device(const fs::path& file, unsigned number) {
  struct stat status {};
  return ::stat(file.c_str(), &status) == 0 && S_ISCHR(status.st_mode) &&
         status.st_rdev == makedev(1, number);
}

TEST_F(Outputs, GoThroughDevicesWhichStay) {
  constexpr unsigned null = 3, full = 7;
  if (!make_device(directory() / "device", null)) GTEST_SKIP() << "no device can be made here";
  begin_ledger();
  for (const Output& output : outputs()) {
    SCOPED_TRACE(output.name);
    const bool may_fail = output.name == std::string("run --progress-file");
    const std::string name = std::to_string(&output - outputs().data());
    for (const unsigned number : {null, full}) {
      const std::string place = "device_" + name + "_" + std::to_string(number);
      const Ended ended = start_at(
          output, place, [&](const fs::path& there) { ASSERT_TRUE(make_device(there, number)); });
      EXPECT_TRUE(is_device(place_of(output, place), number));
      if (!output.file.empty()) {
        EXPECT_EQ(ended.status, 4) << ended.out << ended.err;
      } else if (number == full && !may_fail) {
        EXPECT_EQ(ended.status, 4) << ended.out << ended.err;
        EXPECT_TRUE(holds(ended.err, "No space left on device"));
      } else {
        EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
      }
    }
  }
}

TEST_F(Outputs, GoThroughPipesWhichStayAndWaitForNoReader) {
  for (const Output& output : outputs()) {
    if (!output.file.empty()) continue;
    SCOPED_TRACE(output.name);
    const fs::path pipe = directory() / ("pipe" + output.ending);
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0666), 0);
    const bool may_fail = output.name == std::string("run --progress-file");
    const Ended unread = tool(put(output.words, pipe.filename().string()));
    EXPECT_EQ(unread.status, may_fail ? 0 : 4) << unread.out << unread.err;
    std::string command;
    for (const std::string& word : put(output.words, pipe.filename().string()))
      command += " '" + word + "'";
    const Ended ended = end_of(
        start("/bin/sh", {"-c",
                          "exec 3<>pipe" + output.ending + "; cat <&3 > got & \"$0\"" + command +
                              " 3>&-; status=$?; for i in 1 2 3 4 5 6 7 8 9; do test -s got && "
                              "break; sleep 1; done; kill $!; exit $status",
                          SLOSH_TOOL}));
    EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
    EXPECT_FALSE(read("got").empty());
    EXPECT_TRUE(fs::is_fifo(pipe));
    fs::remove(pipe);
  }
}

TEST_F(Outputs, RefuseEmptyPathsByTheNameOfTheOption) {
  std::vector<Words> all{{"--store", "run", "./small.toml", "theory", "--store", ""},
                         {"--store", "store", "--store", ""},
                         {"--store", "store", "--store="},
                         {"--output", "campaign", "./surges.toml", "-o", ""},
                         {"--output", "gate", "./surges.toml", "--output="},
                         {"--output", "case", "./small.toml", "--for", "csv", "-o", ""},
                         {"--output", "new", "other", "--like", "./small.toml", "-o", ""},
                         {"--output", "run", "rigid_rotation", "-o", ""},
                         {"--ledger", "gate", "./surges.toml", "--ledger", ""},
                         {"--ledger", "baseline", "approve", "./surges.toml", "--ledger", "",
                          "--new", "--who", "a", "--reason", "b"},
                         {"--campaign", "run", "./small.toml", "theory", "--campaign", ""},
                         {"--experiments", "explain", "./small.toml", "--experiments", ""},
                         {"--case", "compare", "theory.h5", "mine.h5", "--case", ""}};
  for (const Output& output : outputs()) {
    const std::size_t last = output.words.size() - 2;
    const std::string option = output.words[last] == "-o" ? "--output" : output.words[last];
    all.push_back(put(output.words, ""));
    all.back().insert(all.back().begin(), option);
  }
  for (const Words& words : all) {
    const Ended ended = tool({words.begin() + 1, words.end()});
    EXPECT_EQ(ended.status, 2) << words[1] << " " << words[0] << ended.out << ended.err;
    EXPECT_TRUE(holds(ended.err, words[0] + ": ")) << words[1];
  }
}

TEST_F(Outputs, OfAFullOrClosedStandardOutputFailEveryCommand) {
  begin_ledger();
  std::vector<Words> all{{"list"},
                         {"list", "--json"},
                         {"explain", "./small.toml"},
                         {"explain", "--keys"},
                         {"store"},
                         {"--version"},
                         {"--help"},
                         {"campaign", "--report-only", "./surges.toml", "-o", "out"},
                         {"campaign", "./surges.toml", "--dry-run"},
                         {"export", "theory.h5", "--csv"}};
  for (const Words& words : all)
    for (const char* target : {"/dev/full", "&-"}) {
      const Ended ended = [&] {
        Words shell{"-c", std::string("\"$@\" >") + target, "sh", SLOSH_TOOL};
        shell.insert(shell.end(), words.begin(), words.end());
        return end_of(start("/bin/sh", shell));
      }();
      EXPECT_EQ(ended.status, 4) << words[0] << " " << target << ended.err;
      EXPECT_TRUE(holds(ended.err, "standard output: expected a place that takes all"));
    }
  EXPECT_EQ(typed("list").status, 0);
}

TEST_F(Outputs, WriteAReportAgainWhosePagesWereRemovedAndKeepAnEditedOne) {
  ASSERT_EQ(campaign().status, 0);
  const std::string page = read(report() / "index.html");
  fs::path figure;
  for (const auto& entry : fs::directory_iterator(report() / "figures")) figure = entry.path();
  const auto expect_written = [&](const char* command, const char* what) {
    const Ended ended = typed(command + std::string(" ./surges.toml --output out"));
    EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
    EXPECT_TRUE(fs::exists(figure)) << what;
    EXPECT_TRUE(fs::exists(report() / "results.json")) << what;
    EXPECT_EQ(read(report() / "index.html").size(), page.size()) << what;
  };
  for (const char* command : {"campaign --report-only", "campaign"}) {
    write("out/report/index.html", "edited");
    expect_written(command, "an edited page");
    EXPECT_EQ(read("out/report/index.html.kept-1"), "edited");
    fs::remove(report() / "index.html");
    expect_written(command, "no page");
    fs::remove(figure);
    expect_written(command, "no figure");
    fs::remove(report() / "results.json");
    expect_written(command, "no data");
    fs::remove_all(report());
    expect_written(command, "no report");
  }
}

// Names alone say of no file that Slosh has made it.
TEST_F(Outputs, SetAsideWhatIsAUsersAndLieBesideTheRest) {
  const std::string notes = "a week of work";
  for (const char* file : {"report/figures/mine.svg", "report/tables/mine.csv", "report/.DS_Store",
                           "report/index.html~", "jobs/list_1/notes.txt"}) {
    fs::create_directories((directory() / "out" / file).parent_path());
    write(std::string("out/") + file, notes);
    for (int i = 0; i < 2; ++i) EXPECT_EQ(campaign().status, 0) << file;
    EXPECT_EQ(read(std::string("out/") + file), notes) << "it is in nobody's way";
  }
  fs::create_directories(directory() / "new/gate/gate.md");
  write("new/gate/gate.md/notes.txt", notes);
  const std::vector<std::string> in_the_way{"report/index.html", "report/results.json",
                                            "runs/small/theory.log"};
  for (const std::string& file : in_the_way) {
    fs::create_directories((directory() / "new" / file).parent_path());
    write("new/" + file, notes);
  }
  const Words end{"./surges.toml", "-o", "new", "--store", "another"};
  const Ended started = tool({"campaign", end[0], end[1], end[2], end[3], end[4]});
  EXPECT_EQ(started.status, 0) << started.err;
  for (const std::string& file : in_the_way) {
    EXPECT_EQ(read("new/" + file + ".kept-1"), notes);
    EXPECT_TRUE(holds(started.err, "it is kept as " + fs::path(file).filename().string()));
  }
  EXPECT_EQ(tool({"gate", end[0], end[1], end[2], end[3], end[4]}).status, 0);
  EXPECT_EQ(read("new/gate/gate.md.kept-1/notes.txt"), notes);
}

// A start that was interrupted, a store that was copied, a user at work in the directory.
TEST_F(Outputs, OfAProgramLeaveThoseOfAUsersWhereTheyAre) {
  const fs::path work = directory() / "mine.work", first = work / "mine.external";
  fs::create_directories(first);
  write("mine.work/mine.external/part.csv", "half");
  write("mine.work/mine.external/notes.txt", "a week of work");
  write("mine.work/mine.external.log", "killed");
  for (int i = 0; i < 3; ++i) {
    const Ended again = run("mine");
    EXPECT_EQ(again.status, 0) << again.err;
    EXPECT_TRUE(holds(again.err, "the program works in mine.external-2"));
  }
  EXPECT_EQ(read("mine.work/mine.external/notes.txt"), "a week of work");
  EXPECT_EQ(read("mine.work/mine.external/part.csv"), "half");
  EXPECT_EQ(read("mine.work/mine.external.log"), "killed");
  EXPECT_FALSE(fs::exists(work / "mine.external-3"));
  write("solve", "#!/bin/sh\nhead -c 100000 /dev/zero > \"$2/half\"; exit 1\n");
  for (int i = 0; i < 3; ++i) EXPECT_EQ(run("mine").status, 3);
  EXPECT_FALSE(fs::exists(work / "mine.external-3")) << "what failed is not kept for ever";
  EXPECT_EQ(run("mine", {"-o", ".slosh"}).status, 2);
}

// Two starts of a run with one name in one directory, of cases that differ.
TEST_F(Outputs, OfTwoStartsAtOnceAreEachItsOwn) {
  write("solve",
        "#!/bin/sh\ncp \"$1\" \"$2/wave.csv\"; sleep 1; test -e \"$2/wave.csv\" || exit 7\n");
  auto first = start(SLOSH_TOOL, {"run", "./small.toml", "mine", "-o", "mine.h5"});
  ::usleep(300'000);
  const Ended second = run("mine");
  first.wait();
  EXPECT_EQ(first.exit_code(), 0);
  EXPECT_EQ(second.status, 0) << second.err;
}

TEST_F(Outputs, OfAStudySetAsideATableOfAUsers) {
  fs::create_directory(directory() / "study");
  write("study/motion.csv", "a week of work");
  EXPECT_NE(typed("converge ./small.toml --family copy --spacings 0.04,0.02,0.01 -o study").status,
            2);
  EXPECT_EQ(read("study/motion.csv.kept-1"), "a week of work");
}

TEST_F(Outputs, KeepAUsersFileWhereTheLinkOfARunGoes) {
  fs::create_directories(directory() / "out/runs/small");
  write("out/runs/small/theory.h5", "my own");
  fs::create_symlink(directory() / "theory.h5", result("mine"));
  const Ended ended = campaign();
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
  EXPECT_EQ(read(result("theory")), "my own");
  EXPECT_EQ(fs::read_symlink(result("mine")), directory() / "theory.h5");
  for (const char* run : {"theory", "mine"})
    EXPECT_TRUE(holds(ended.err, result(run).string() + " is kept"));
}

}  // namespace
}  // namespace slosh::outputs_test
