// Files and programs of others that try to read what is not theirs, to hold Slosh up, to crash it
// or to command the terminal that shows what they said.
#include <chrono>
#include <nlohmann/json.hpp>

#include "verification/files/content_hash.hpp"
#include "verification/results/result_file.hpp"
#include "verification/tests/hdf5_attacks.hpp"
#include "verification/tests/small_campaign.hpp"

namespace slosh::intruders_test {
namespace {

namespace fs = std::filesystem;

const std::string secret = "ghp_SecretOfTheRunner";

class Intruders : public SmallCampaign {
 protected:
  // Ends within seconds, and tells nothing of the environment.
  Ended quick(const std::vector<std::string>& words) const {
    const auto begin = std::chrono::steady_clock::now();
    const Ended ended = tool(words, {{"TOKEN", secret}});
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(60));
    EXPECT_EQ((ended.out + ended.err).find(secret), std::string::npos) << ended.out << ended.err;
    EXPECT_GE(ended.status, 0) << "killed: " << ended.err;
    return ended;
  }
  static bool has_controls(const std::string& text) {
    for (const char letter : text)
      if ((static_cast<unsigned char>(letter) < 0x20 && letter != '\n' && letter != '\t') ||
          letter == 0x7f)
        return true;
    return false;
  }
};

// A run of a shell script that gets the case's directory as $0 and is in its work directory; the
// program that follows it prints the theory.
std::string scripted_run(const std::string& script, const std::string& more = "") {
  return "[[run]]\nname = \"mine\"\nsolver = \"external\"\ncommand = [\"sh\", \"-c\", '''" +
         script +
         "''', \"{case_directory}\", \"" STAND_IN_SOLVER
         "\", \"{case_file}\", \"wave.csv\", \"scaled\", \"1.01\"]\n" +
         more + wave_series;
}

const std::string solve = "\"$@\"; ", facts = "facts = \"cost.json\"\n";

TEST_F(Intruders, LeaveNothingThatIsReadInThePlaceOfAFile) {
  write("outside.json", R"({"schema_version": 1, "steps": 7})");
  write("outside.csv", "t [s];eta [m]\n0;1\n1;2\n2;3\n8;4\n");
  const std::string no_file = "expected a regular file in the work directory";
  struct Left {
    std::string script, more, words;
  };
  const Left all[] = {
      {solve + "mkfifo cost.json", facts, no_file},
      {solve + "ln -s /proc/self/environ cost.json", facts, no_file},
      {solve + "ln -s \"$0\"/outside.json cost.json", facts, no_file},
      {solve + "ln -s none cost.json", facts, no_file},
      {solve + "ln -s cost.json cost.json", facts, no_file},
      {solve + "ln -s /dev/zero cost.json", facts, no_file},
      {solve + "ln -s wave.csv/.. cost.json", facts, no_file},
      {solve + "mkdir cost.json", facts, no_file},
      {solve + "python3 -c 'import socket; socket.socket(socket.AF_UNIX).bind(\"cost.json\")'",
       facts, no_file},
      {"mkfifo wave.csv", "", no_file},
      {"ln -s \"$0\"/outside.csv wave.csv", "", no_file},
      {"ln -s /proc/self/environ wave.csv", "", no_file},
      {"ln -s /dev/zero wave.csv", "", no_file},
      {"mkdir -p wave/0; ln -s \"$0\"/outside.csv wave/0/wave.csv; ln -s wave/0/wave.csv .", "",
       no_file},
      {"rm -r ../mine.external; ln -s \"$0\" ../mine.external; cp \"$0\"/outside.csv "
       "\"$0\"/wave.csv",
       "", no_file},
      {solve + "truncate -s 1T cost.json", facts, "1099511627776 bytes: expected at most"},
      {"rm ../mine.external.log; mkfifo ../mine.external.log", "", "in the place of its log"},
      {"ln -sf /proc/self/environ ../mine.external.log; exit 1", "", "it said nothing"},
      {solve + "ln -sf /dev/zero ../mine.external.log", "fail_on = [\"a\"]\n",
       "in the place of its log"},
  };
  for (const auto& [script, more, words] : all) {
    // A link that a former one left there leads to the case.
    std::filesystem::remove_all(directory() / "mine.work");
    write("small.toml", small_case + scripted_run(script, more));
    const Ended ended = quick({"run", "./small.toml", "mine"});
    EXPECT_EQ(ended.status, 3) << script;
    EXPECT_TRUE(holds(ended.err, words)) << script;
  }
}

// The version command is a program of theirs too.
TEST_F(Intruders, GetTheTankBeforeAnyOfTheirProgramsRuns) {
  write("own.txt", "mine");
  const std::string version =
      "version_command = [\"sh\", \"-c\", 'ln -sf \"$0\"/own.txt tank.json; echo 1', "
      "\"{case_directory}\"]\n";
  write("small.toml", small_case + scripted_run(": {tank_file}; \"$@\"", version));
  const Ended ended = quick({"run", "./small.toml", "mine"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(read("own.txt"), "mine");
}

// What it wrote of the files that it left may be a link within its own directory.
TEST_F(Intruders, MayLinkWithinTheirDirectory) {
  write("small.toml",
        small_case + scripted_run("\"$@\"; mv wave.csv real.csv; ln -s real.csv wave.csv"));
  EXPECT_EQ(quick({"run", "./small.toml", "mine"}).status, 0);
}

TEST_F(Intruders, CommandNoTerminalAndBreakNoDocument) {
  const std::string speech = R"(printf 'a\033[31mred\033[2J\001 \302\233x \377 \b\r\177 end\n'; )";
  const std::string version = "version_command = [\"printf\", '\\033]0;x\\007My\\001 SPH\\n']\n";
  const auto row = [](const char* limit) {
    return with(with(gate_on("mine"), "limit = 0.3", limit), "The runs are coarse.", "A copy.");
  };
  for (const auto& [script, status] : {std::pair{speech + solve, 0}, {speech + "exit 1", 3}}) {
    write_campaign(small_case + scripted_run(script, version) + row("limit = 0.3"));
    for (const char* command : {"campaign", "gate"}) {
      const Ended ended = quick({command, "./surges.toml", "--output", "out"});
      EXPECT_EQ(ended.status, status) << ended.out << ended.err;
      EXPECT_FALSE(has_controls(ended.out + ended.err)) << ended.out << ended.err;
    }
    int documents = 0;
    for (const auto& entry : fs::recursive_directory_iterator(directory() / "out")) {
      const std::string kind = entry.path().extension();
      if (kind != ".svg" && kind != ".html" && kind != ".md" && kind != ".xml" && kind != ".json")
        continue;
      if (entry.path().filename().string().find(".failure.") != std::string::npos) continue;
      ++documents;
      EXPECT_FALSE(has_controls(read(entry.path()))) << entry.path();
    }
    EXPECT_GT(documents, 5);
    EXPECT_TRUE(holds(report_words(), status == 0 ? "My SPH" : "ared"));
  }
}

TEST_F(Intruders, PutNoControlCharacterIntoATitle) {
  for (const char* letter : {"\\u0001", "\\u001B[2J", "\\b", "\\r", "\\u007F", "\\u0085"}) {
    write("small.toml",
          with(small_case, "\"A small surge\"", "\"A small " + std::string(letter) + " surge\""));
    const Ended ended = quick({"explain", "./small.toml"});
    EXPECT_EQ(ended.status, 2) << letter;
    EXPECT_TRUE(holds(ended.err, "small.toml:3: a text with a control character"));
    EXPECT_FALSE(has_controls(ended.err));
  }
  write("small.toml", with(small_case, "\"A small surge\"", R"("A\tsmall \u00B0 \"surge\"")"));
  EXPECT_EQ(quick({"explain", "./small.toml"}).status, 0);
}

TEST_F(Intruders, HoldNoSearchOfALogUp) {
  const std::string letters = "printf '%030000d!\\n' 0; ";
  for (const char* pattern : {"(0+)+$", "(0|00)+x", "(0*)*x", "^(0?){900}x"}) {
    write("small.toml", small_case + scripted_run(letters + solve,
                                                  "fail_on = ['" + std::string(pattern) + "']\n"));
    EXPECT_EQ(quick({"run", "./small.toml", "mine"}).status, 0) << pattern;
  }
  for (const std::string& pattern :
       {std::string(R"((0)\1)"), std::string("(?=0)"), std::string(20'000, '(') + "0",
        std::string("((0{99}){99}){99}")}) {
    write("small.toml", small_case + scripted_run(solve, "fail_on = ['" + pattern + "']\n"));
    const Ended ended = quick({"explain", "./small.toml"});
    EXPECT_EQ(ended.status, 2) << pattern.substr(0, 20);
    EXPECT_TRUE(holds(ended.err, "neither back-references nor look-around"));
  }
  const std::string nested = std::string(20'000, '(') + "0" + std::string(20'000, ')');
  write("small.toml", small_case + scripted_run(letters + solve, "fail_on = ['" + nested + "']\n"));
  EXPECT_TRUE(holds(quick({"run", "./small.toml", "mine"}).err, "line 1 of its log matches"));
}

TEST_F(Intruders, HoldNoCheckUpByATableOfMillionsOfRows) {
  std::string rows = "time_s,displacement_m\n";
  for (int i = 0; i <= 2'000'000; ++i) rows += std::to_string(i) + ",0.1\n";
  write("surge.csv", rows);
  write("small.toml",
        with(with(small_case, "\"sine\"\namplitude_m = 0.02", "\"table\"\nfile = \"surge.csv\""),
             "angular_frequency_rad_s = 3.0\n", ""));
  const Ended ended = quick({"explain", "./small.toml"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_TRUE(holds(ended.err, "surge.csv:2000002: time_s = 2000000: expected at most 2000000"));
}

TEST_F(Intruders, NestNoValuesTooDeep) {
  const std::string deep = std::string(200'000, '[') + std::string(200'000, ']');
  write("deep.json", deep);
  write("steps.json", "{\"schema_version\": 1, \"steps\": " + deep + "}");
  for (const char* file : {"deep.json", "steps.json"}) {
    write("small.toml",
          small_case + scripted_run(solve + "cp \"$0\"/" + file + " cost.json", facts));
    const Ended ended = quick({"run", "./small.toml", "mine"});
    EXPECT_EQ(ended.status, 3);
    EXPECT_TRUE(holds(ended.err, "nested too deep"));
  }
  std::string key = "a";
  for (int i = 0; i < 200'000; ++i) key += i % 2 == 0 ? ".a" : ". \"b\"";
  for (const std::string& text :
       {with(small_case, "tags = []", "tags = " + deep), small_case + key + " = 1\n",
        small_case + "[" + key + "]\n", small_case + "[[" + key + "]]\n",
        small_case + "[other]\nx = { " + key + " = 1 }\n"}) {
    write("small.toml", text);
    EXPECT_EQ(quick({"explain", "./small.toml"}).status, 2) << text.substr(text.size() - 100);
  }
  write_campaign(small_case);
  write("ledger", deep + "\n");
  write("ledger.head", deep);
  const Ended gate = quick({"gate", "./surges.toml", "--output", "out", "--ledger", "ledger"});
  EXPECT_GT(gate.status, 0);
  EXPECT_TRUE(holds(gate.err, "nested too deep"));
  fs::create_directories(directory() / "all/surges/report");
  write("all/surges/report/results.json", deep);
  const Ended all = quick({"campaign", "--report-only", "--all", "--output", "all"});
  EXPECT_GT(all.status, 0);
  EXPECT_TRUE(holds(all.err, "nested too deep"));
}

const std::string stored_run = R"([[run]]
name = "theirs"
solver = "stored"
method = "theirs"
particle_spacing_m = 0.02
facts = "facts.json"
[[run.series]]
quantity = "elevation@right"
file = "a.h5"
format = "hdf5"
column = "value"
unit = "m"
time_column = "time"
time_unit = "s"
)";
const std::string stored_facts = R"({"schema_version": 1, "software": "S", "date": "d",
"machine": "m", "simulated_time_s": 8, "processor_time_s": 1})";

TEST_F(Intruders, LeadNoImportAndNoStoredRunIntoOtherFiles) {
  write_secrets(directory());
  write("facts.json", stored_facts);
  write("small.toml", small_case + stored_run);
  for (const Hdf5Attack& attack : hdf5_attacks(directory())) {
    {
      const hdf5::Handle root(
          H5Fcreate((directory() / "a.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT),
          H5Fclose, "make a file");
      std::vector<double> times(secret_length);
      for (std::size_t i = 0; i < times.size(); ++i) times[i] = static_cast<double>(i);
      hdf5::write_numbers(root, "time", times);
      attack.plant(root, "value");
    }
    const Ended imported =
        quick({"import", "a.h5", "--format", "hdf5", "--time", "time", "--time-unit", "s", "--unit",
               "m", "--series", "elevation@right=value", "-o", "b.h5"});
    EXPECT_EQ(imported.status, 2) << attack.name;
    EXPECT_TRUE(holds(imported.err, "a.h5: ")) << attack.name;
    EXPECT_TRUE(holds(imported.err, attack.refusal)) << attack.name;
    EXPECT_FALSE(fs::exists(directory() / "b.h5")) << attack.name;
    const Ended run = quick({"run", "./small.toml", "theirs"});
    EXPECT_NE(run.status, 0) << attack.name;
    EXPECT_TRUE(holds(run.err, attack.refusal)) << attack.name;
  }
}

// A result with a true seal around a content that leads elsewhere.
TEST_F(Intruders, LeadNoResultIntoOtherFiles) {
  write_secrets(directory());
  const fs::path file = directory() / "a.h5";
  for (const Hdf5Attack& attack : hdf5_attacks(directory())) {
    RunResult result{};
    result.series = {{"elevation@right", "m", std::vector<double>(secret_length, 0), {}}};
    result.series[0].value = result.series[0].time;
    write_result(result, file);
    {
      const hdf5::QuietErrors quiet;
      const hdf5::Handle root(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose, "open");
      const hdf5::Handle series = hdf5::open_group(root, "series/elevation@right");
      hdf5::checked(H5Ldelete(series, "value", H5P_DEFAULT), "remove");
      attack.plant(series, "value");
    }
    const std::string image = read_bytes(file);
    std::ofstream(file, std::ios::binary | std::ios::app)
        << "\nslosh result 002 " << content_hash(image) << "\n";
    const Ended exported = quick({"export", "a.h5", "--csv"});
    EXPECT_EQ(exported.status, 4) << attack.name;
    EXPECT_TRUE(holds(exported.err, attack.refusal)) << attack.name;
    EXPECT_EQ(exported.out.find("41.75"), std::string::npos) << attack.name;
    EXPECT_EQ(quick({"compare", "a.h5", "a.h5"}).status, 4) << attack.name;
  }
}

// What a pull request may name, and what it may not: a checkout lies beside the secrets of a
// runner.
TEST_F(Intruders, ReadNoDataOutsideTheRepositoryOfTheirCase) {
  const std::string table = secret + ";b\n1;2\n",
                    json = "{\"schema_version\": 1, \"auths\": \"" + secret + "\"}";
  fs::create_directories(directory() / "repository/.git");
  fs::create_directories(directory() / "repository/cases");
  fs::create_directories(directory() / "repository/data");
  for (const char* place : {"", "repository/.git/", "repository/data/."}) {
    write(place + std::string("token.csv"), table);
    write(place + std::string("docker.json"), json);
    write(place + std::string("case.toml"), secret + "\n");
  }
  fs::create_symlink(directory() / "token.csv", directory() / "repository/data/linked.csv");
  fs::create_directory_symlink(directory(), directory() / "repository/linked");
  const std::string absolute = (directory() / "token.csv").string();
  const auto motion = [](const std::string& file) {
    return with(small_case, "type = \"sine\"\namplitude_m = 0.02\nangular_frequency_rad_s = 3.0",
                "type = \"table\"\nfile = \"" + file + "\"");
  };
  const auto stored = [](const std::string& file, const std::string& facts) {
    return small_case +
           with(with(with(with(stored_run, "\"a.h5\"", "\"" + file + "\""), "hdf5", "csv"),
                     "\"facts.json\"", "\"" + facts + "\""),
                "column = \"value\"", "column = \"b\"");
  };
  std::vector<std::string> cases;
  for (const std::string& file :
       {std::string("../../token.csv"), absolute, std::string("../data/linked.csv"),
        std::string("../linked/token.csv"), std::string("../.git/token.csv"),
        std::string("../data/.token.csv"), "/proc/self/root" + absolute}) {
    cases.push_back(motion(file));
    cases.push_back(stored(file, "../data/facts.json"));
    cases.push_back(small_case + "[[run]]\nname = \"earlier\"\nsolver = \"record\"\nfile = \"" +
                    file + "\"\n");
  }
  for (const char* file : {"../../docker.json", "../.git/docker.json", "../linked/docker.json"})
    cases.push_back(stored("../data/series.csv", file));
  write("repository/data/facts.json", stored_facts);
  write("repository/data/series.csv", "time,b\n0,1\n1,1\n2,1\n9,1\n");
  for (const std::string& text : cases) {
    write("repository/cases/small.toml", text);
    const Ended ended = quick({"explain", "repository/cases/small.toml"});
    EXPECT_EQ(ended.status, 2) << text.substr(text.size() - 300);
    EXPECT_TRUE(holds(ended.err, "links followed, and not a hidden one")) << ended.err;
  }
  write("repository/cases/small.toml", stored("../data/series.csv", "../data/facts.json"));
  EXPECT_EQ(quick({"explain", "repository/cases/small.toml"}).status, 0);
  for (const char* member : {"../../case.toml", "../.git/case.toml", "../linked/case.toml"}) {
    write("repository/cases/all.toml",
          "schema_version = 1\nname = \"all\"\ntitle = \"A\"\nsource = \"b\"\ncases = [\"" +
              std::string(member) + "\"]\n");
    EXPECT_EQ(quick({"gate", "repository/cases/all.toml", "-o", "out"}).status, 2) << member;
  }
  // Without a repository, data lie below the case's directory or the current one.
  fs::remove_all(directory() / "repository/.git");
  EXPECT_EQ(quick({"explain", "repository/cases/small.toml"}).status, 0);
  for (const auto& [place, file] : {std::pair{"repository/cases", "../../token.csv"},
                                    {"repository/cases", "../data/token.csv"},
                                    {"repository", "../token.csv"},
                                    {"repository/cases", "../token.csv"},
                                    {"/", "../token.csv"}}) {
    write("repository/data/token.csv", secret + ",eta_m\n0,1\n");
    write("repository/token.csv", secret + ",eta_m\n0,1\n");
    write("repository/cases/small.toml", motion(file));
    write("repository/small.toml", motion(file));
    const std::string name = place == std::string("repository") ? "repository/small.toml"
                                                                : "repository/cases/small.toml";
    const Ended ended =
        end_of(start("/bin/sh", {"-c", "cd \"$0\" && exec \"$@\"", place, SLOSH_TOOL, "explain",
                                 (directory() / name).string()}));
    EXPECT_EQ(ended.status, 2) << place << " " << file;
    EXPECT_EQ(ended.err.find(secret), std::string::npos) << ended.err;
  }
}

// A program, a table or a result may say twenty megabytes where a message would quote a word.
TEST_F(Intruders, AreQuotedAtALengthThatCanBeRead) {
  const std::string longest(20'000'000, 'x');
  write("long", longest);
  write("head.csv", "time," + longest + "\n0,1\n");
  EXPECT_LT(quick({"import", "head.csv", "--format", "csv", "--time", "t", "--series",
                   "elevation@right=b", "-o", "b.h5"})
                .err.size(),
            4000u);
  for (const char* script : {"cat \"$0\"/long; exit 1", "cat \"$0\"/long >&2; exit 1",
                             "printf '{\"%s\": 1, \"schema_version\": 1}' $(head -c 900000 "
                             "\"$0\"/long) > cost.json; \"$@\""}) {
    write_campaign(small_case + scripted_run(script, facts) + own_row("amplitude_error", "0.3"));
    EXPECT_EQ(quick({"gate", "./surges.toml", "-o", "out"}).status, 3) << script;
    for (const char* file : {"gate.md", "junit.xml"})
      EXPECT_LT(fs::file_size(directory() / "out/gate" / file), 100'000u) << script;
  }
  write_campaign(small_case +
                 scripted_run(solve, "version_command = [\"cat\", \"{case_directory}/long\"]\n") +
                 own_row("amplitude_error", "0.3"));
  EXPECT_EQ(quick({"campaign", "./surges.toml", "-o", "out"}).status, 0);
  EXPECT_LT(fs::file_size(result("mine")), 1'000'000u);
}

TEST_F(Intruders, NameNoDirectoryThatCommandsTheTerminal) {
  ASSERT_NO_FATAL_FAILURE(write_campaign(small_case));
  const fs::path place = directory() / "out" / "\x1b[2Jred" / "report";
  fs::create_directories(place);
  std::ofstream(place / "results.json") << "[]";
  const Ended ended = quick({"campaign", "--report-only", "--all", "-o", "out"});
  EXPECT_TRUE(holds(ended.err, "out/red/report/results.json"));
  EXPECT_FALSE(has_controls(ended.err + ended.out));
}

// What takes long must not stand in the way of a check.
TEST_F(Intruders, AreCheckedWithoutTheEstimatesOfTheirTheories) {
  std::string many = small_case;
  for (int i = 0; i < 200; ++i)
    many += "[[run]]\nname = \"theory_" + std::to_string(i) +
            "\"\nsolver = \"linear\"\nmodes = 500\nvalid_elevation_over_depth = 0.2\n";
  write("small.toml", many);
  EXPECT_EQ(quick({"explain", "./small.toml"}).status, 0);
  write("small.toml", with(small_case, "sample_interval_s = 0.01", "sample_interval_s = 0.000004"));
  EXPECT_EQ(quick({"explain", "./small.toml"}).status, 0);
}

TEST_F(Intruders, ReadNoRecordOutsideTheDirectoryOfTheRecords) {
  write("token.csv", secret + ",eta_m\n0,1\n");
  write("small.toml", small_case + R"([[run]]
name = "measured"
solver = "record"
experiment = "wave.csv"
time_column = "t_s"
value_column = "eta_m"
quantity = "elevation@right"
unit = "m"
)");
  fs::create_directory(directory() / "records");
  fs::create_symlink("../token.csv", directory() / "records/wave.csv");
  const Ended ended = quick({"explain", "./small.toml", "--experiments", "records"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_TRUE(holds(ended.err, "experiment = \"wave.csv\": expected a file below "));
}

TEST_F(Intruders, ReadNoFileOfHolesThatIsLargerThanAny) {
  write("sparse", "");
  fs::resize_file(directory() / "sparse", std::uintmax_t{100} << 30);
  const std::string too_large = "cannot read 107374182400 bytes, expected at most 1000000000";
  write_campaign(with(small_case,
                      "type = \"sine\"\namplitude_m = 0.02\nangular_frequency_rad_s = 3.0",
                      "type = \"table\"\nfile = \"sparse\""));
  std::vector<std::vector<std::string>> all{{"explain", "./small.toml"},
                                            {"explain", "./sparse"},
                                            {"export", "sparse", "--csv"},
                                            {"compare", "sparse", "sparse"}};
  for (const char* format : {"csv", "hdf5"})
    all.push_back({"import", "sparse", "--format", format, "--time", "t", "--unit", "m",
                   "--time-unit", "s", "--series", "elevation@right=b", "-o", "b.h5"});
  for (const auto& words : all) {
    const Ended ended = quick(words);
    EXPECT_GT(ended.status, 0) << words[0];
    EXPECT_TRUE(holds(ended.err, "sparse")) << words[0];
    EXPECT_TRUE(words[1] == "./sparse" || holds(ended.err, too_large)) << words[0];
  }
  write_campaign(small_case);
  const Ended gate = quick({"gate", "./surges.toml", "--output", "out", "--ledger", "sparse"});
  EXPECT_EQ(gate.status, 4);
  EXPECT_TRUE(holds(gate.err, too_large));
}

TEST_F(Intruders, ReadNothingOfThisProcess) {
  const std::string environment = "/proc/self/environ";
  write("small.toml", small_case + with(with(stored_run, "\"a.h5\"", "\"" + environment + "\""),
                                        "facts.json", environment));
  EXPECT_NE(quick({"run", "./small.toml", "theirs"}).status, 0);
  for (const char* format : {"csv", "hdf5", "sphinxsys", "openfoam_probes"}) {
    std::vector<std::string> words{"import", environment, "--format",
                                   format,   "--series",  "elevation@right=TOKEN",
                                   "-o",     "b.h5"};
    if (format == std::string("csv")) words.insert(words.end(), {"--time", "t"});
    EXPECT_NE(quick(words).status, 0) << format;
  }
  EXPECT_NE(quick({"explain", environment}).status, 0);
  write("small.toml", with(small_case,
                           "type = \"sine\"\namplitude_m = 0.02\n"
                           "angular_frequency_rad_s = 3.0",
                           "type = \"table\"\nfile = \"" + environment + "\""));
  EXPECT_NE(quick({"explain", "./small.toml"}).status, 0);
}

}  // namespace
}  // namespace slosh::intruders_test
