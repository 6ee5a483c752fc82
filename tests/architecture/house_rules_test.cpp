// Leda's own tree keeps the rules; made-up trees show that each of them is noticed when broken.

#include "tests/architecture/house_rules.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

namespace leda::architecture {
namespace {

std::string include(const std::string& target) { return "#include \"" + target + "\"\n"; }

SourceTree with(const std::string& file, const std::string& text, SourceTree tree = {}) {
  tree[file] = text;
  return tree;
}

TEST(HouseRules, TheSourceTreeWasRead) {
  const SourceTree tree = read_source_tree(LEDA_SOURCE_DIR);
  for (const std::string room : {"solver", "profiles", "db", "server", "tests"}) {
    const auto files = std::count_if(tree.begin(), tree.end(), [&](const auto& entry) {
      return room_of(entry.first) == room && is_cpp(entry.first);
    });
    EXPECT_GE(files, 5) << room;
  }
  const auto store = tree.find("db/store.hpp");
  ASSERT_NE(store, tree.end());
  EXPECT_FALSE(includes_of(store->second).empty());
}

TEST(HouseRules, LedaKeepsThem) {
  for (const Breach& breach : all_breaches(read_source_tree(LEDA_SOURCE_DIR)))
    ADD_FAILURE() << breach;
}

TEST(HouseRules, AMadeUpTreeThatKeepsThemHasNoBreach) {
  SourceTree tree;
  tree["solver/section/point.hpp"] = "#include <vector>\n";
  tree["solver/kernel/step.cpp"] =
      include("solver/section/point.hpp") + "#include <hwy/highway.h>\n";
  tree["profiles/map/line.hpp"] = include("solver/section/point.hpp") + "#include <string>\n";
  tree["profiles/dem.hpp"] = include("profiles/map/line.hpp");
  tree["profiles/gdal_handle.hpp"] = "#include <gdal_priv.h>\n";
  tree["profiles/dem.cpp"] = include("profiles/dem.hpp") + include("profiles/gdal_handle.hpp");
  tree["db/store.hpp"] = include("profiles/map/line.hpp") + include("solver/section/point.hpp");
  tree["db/store.cpp"] =
      include("db/store.hpp") + include("disk/new_file.hpp") + "#include <SQLiteCpp/SQLiteCpp.h>\n";
  tree["server/main.cpp"] = include("db/store.hpp") + include("profiles/dem.hpp") +
                            include("solver/kernel/step.hpp") + "#include <httplib.h>\n";
  tree["tests/db/store_test.cpp"] = include("db/store.hpp") + "#include <sqlite3.h>\n";
  tree["README.md"] = "See https://example.org/root/ and ${HOME}/work/ for more.\n";
  for (const Breach& breach : all_breaches(tree)) ADD_FAILURE() << breach;
}

struct Wrong {
  std::string file;
  std::string target;
};

class WrongDirection : public ::testing::TestWithParam<Wrong> {};

TEST_P(WrongDirection, IsNoticed) {
  const auto& [file, target] = GetParam();
  const auto found = wrong_directions(with(file, "// a line\n" + include(target)));
  ASSERT_EQ(found.size(), 1U) << file << " includes " << target;
  EXPECT_EQ(found[0].file, file);
  EXPECT_EQ(found[0].line, 2);
  EXPECT_NE(found[0].what.find(target), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Rooms, WrongDirection,
                         ::testing::Values(Wrong{"solver/kernel/step.cpp", "profiles/map/line.hpp"},
                                           Wrong{"solver/kernel/step.hpp", "db/store.hpp"},
                                           Wrong{"solver/section/a.hpp", "server/problem.hpp"},
                                           Wrong{"profiles/dem.cpp", "solver/kernel/step.hpp"},
                                           Wrong{"profiles/dem.cpp",
                                                 "solver/materials/softening.hpp"},
                                           Wrong{"profiles/dem.cpp", "db/store.hpp"},
                                           Wrong{"disk/sha256.cpp", "db/store.hpp"},
                                           Wrong{"disk/a.hpp", "solver/section/point.hpp"},
                                           Wrong{"solver/run/a.cpp", "disk/sha256.hpp"},
                                           Wrong{"db/store.cpp", "solver/run/simulate.hpp"},
                                           Wrong{"db/store.cpp", "profiles/dem.hpp"},
                                           Wrong{"db/store.cpp", "server/problem.hpp"},
                                           Wrong{"server/main.cpp", "tests/db/samples.hpp"},
                                           Wrong{"server/main.cpp", "deploy/demo/dem.hpp"},
                                           Wrong{"deploy/demo/dem.cpp", "profiles/dem.hpp"}));

TEST(HouseRules, AnArrowBackBetweenInnerRoomsIsNoticed) {
  const std::vector<Wrong> wrong = {{"solver/materials/a.cpp", "solver/kernel/grid.hpp"},
                                    {"solver/kernel/a.cpp", "solver/statics/statics.hpp"},
                                    {"solver/statics/a.cpp", "solver/run/audit.hpp"},
                                    {"solver/screening/a.cpp", "solver/kernel/grid.hpp"},
                                    {"solver/element_test/a.cpp", "solver/run/simulate.hpp"},
                                    {"solver/section/a.cpp", "solver/materials/softening.hpp"},
                                    {"server/jobs/a.cpp", "server/http/limits.hpp"},
                                    {"server/layers/a.cpp", "server/http/site.hpp"},
                                    {"server/layers/a.cpp", "server/jobs/service.hpp"},
                                    {"server/http/handlers/a.cpp", "server/commands/commands.hpp"},
                                    {"server/jobs/executors/slurm/a.hpp", "server/http/auth.hpp"},
                                    {"server/run/a.cpp", "server/jobs/service.hpp"},
                                    {"server/documents/a.cpp", "server/run/run_folder.hpp"},
                                    {"server/drawings/a.cpp", "server/layers/summary.hpp"},
                                    {"server/operate/a.cpp", "server/run/run_folder.hpp"}};
  for (const auto& [file, target] : wrong) {
    const auto found = wrong_directions_inside(with(file, "// a line\n" + include(target)));
    ASSERT_EQ(found.size(), 1U) << file << " includes " << target;
    EXPECT_EQ(found[0].line, 2);
  }
  EXPECT_EQ(wrong_directions_inside(with("solver/cellar/a.cpp", "")).size(), 1U);
  EXPECT_EQ(wrong_directions_inside(with("server/cellar/a.cpp", "")).size(), 1U);
  EXPECT_TRUE(wrong_directions_inside(
                  with("server/http/handlers/a.cpp",
                       include("server/jobs/service.hpp") + include("server/http/site.hpp")))
                  .empty());
}

TEST(HouseRules, HeadersThatIncludeEachOtherAreNoticed) {
  SourceTree tree = with("solver/run/a.hpp", include("solver/run/b.hpp"));
  tree["solver/run/b.hpp"] = include("solver/run/c.hpp");
  tree["solver/run/c.cpp"] = include("solver/run/a.hpp");
  tree["solver/run/c.hpp"] = "";
  EXPECT_TRUE(circles(tree).empty());
  tree["solver/run/c.hpp"] = include("solver/run/a.hpp");
  const auto found = circles(tree);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].what.find("solver/run/a.hpp > solver/run/b.hpp > solver/run/c.hpp > "),
            std::string::npos);
}

TEST(HouseRules, BracketsAndSpacesDoNotHideAnInclude) {
  EXPECT_EQ(wrong_directions(with("solver/a.cpp", "#include <db/store.hpp>\n")).size(), 1U);
  EXPECT_EQ(wrong_directions(with("solver/a.cpp", "  #  include \"db/store.hpp\"\n")).size(), 1U);
  EXPECT_TRUE(wrong_directions(with("solver/a.cpp", "// #include \"db/store.hpp\"\n")).empty());
}

TEST(HouseRules, AnIncludeFromItsOwnFolderIsNoticed) {
  SourceTree tree = with("solver/kernel/grid.hpp", "");
  tree["solver/materials/a.hpp"] = "";
  EXPECT_EQ(wrong_directions(with("solver/kernel/step.cpp", include("grid.hpp"), tree)).size(), 1U);
  EXPECT_EQ(
      wrong_directions(with("solver/materials/b.cpp", include("../kernel/grid.hpp"), tree)).size(),
      1U);
  EXPECT_TRUE(
      wrong_directions(with("solver/kernel/step.cpp", include("solver/kernel/grid.hpp"), tree))
          .empty());
}

TEST(HouseRules, APorchThatStandsOnMoreIsNoticed) {
  for (const std::string& text :
       {include("solver/kernel/step.hpp"), std::string("#include <nlohmann/json.hpp>\n"),
        std::string("#include <unistd.h>\n"), include("profiles/dem.hpp")}) {
    EXPECT_EQ(porches_with_walls(with("solver/section/a.hpp", text)).size(), 1U) << text;
    EXPECT_EQ(porches_with_walls(with("profiles/map/a.hpp", text)).size(), 1U) << text;
  }
}

TEST(HouseRules, ALibraryOutsideItsRoomIsNoticed) {
  for (const std::string header :
       {"gdal_priv.h", "gdal.h", "ogrsf_frmts.h", "ogr_api.h", "cpl_conv.h", "gdal/gdal.h",
        "sqlite3.h", "SQLiteCpp/Database.h", "hdf5.h", "H5Cpp.h", "httplib.h"}) {
    const auto found = open_fences(with("solver/a.cpp", "#include <" + header + ">\n"));
    ASSERT_EQ(found.size(), 1U) << header;
    EXPECT_NE(found[0].what.find(header), std::string::npos);
  }
  EXPECT_EQ(open_fences(with("server/a.cpp", "#include <sqlite3.h>\n")).size(), 1U);
  EXPECT_EQ(open_fences(with("profiles/a.cpp", "#include <hdf5.h>\n")).size(), 1U);
  EXPECT_EQ(open_fences(with("db/a.cpp", "#include <gdal.h>\n")).size(), 1U);
}

TEST(HouseRules, ALibrarySeenThroughAHeaderOfOursIsNoticed) {
  SourceTree tree;
  tree["db/database.hpp"] = "#include <SQLiteCpp/SQLiteCpp.h>\n";
  tree["db/store.hpp"] = include("db/database.hpp");
  tree["db/store.cpp"] = include("db/store.hpp");
  EXPECT_TRUE(open_fences(tree).empty());
  tree["server/main.cpp"] = include("db/store.hpp");
  const auto found = open_fences(tree);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].file, "server/main.cpp");
  EXPECT_NE(found[0].what.find("db/store.hpp > db/database.hpp > SQLiteCpp"), std::string::npos);
}

TEST(HouseRules, InnerPartsOfHttplibOutsideTheirFileAreNoticed) {
  for (const std::string text :
       {"class A final : public httplib::Stream {", "class A : public httplib::Server {",
        "if (response.content_length_ > 0) return;", "http.new_task_queue = [] {};",
        "process_request(stream, true, closed, setup);", "httplib::detail::parse();"}) {
    const auto found = inner_parts_of_httplib(with("server/http/send_answer.cpp", "\n" + text));
    ASSERT_EQ(found.size(), 1U) << text;
    EXPECT_EQ(found[0].line, 2);
    EXPECT_TRUE(inner_parts_of_httplib(with("server/http/guarded_http.cpp", text)).empty());
  }
  EXPECT_TRUE(inner_parts_of_httplib(with("server/http/a.cpp", "httplib::Server& http;")).empty());
}

TEST(HouseRules, ADrawerIsNoticed) {
  for (const std::string file : {"solver/utils.hpp", "db/util/text.cpp", "server/common/a.hpp",
                                 "tests/helpers.cpp", "profiles/helper.hpp", "server/misc.cpp"})
    EXPECT_EQ(drawers(with(file, "")).size(), 1U) << file;
  EXPECT_TRUE(drawers(with("solver/utilization.hpp", "")).empty());
}

TEST(HouseRules, AStrayAtTheTopIsNoticed) {
  for (const std::string file : {"pid", "server.log", "leda.db"})
    EXPECT_EQ(strays_at_the_top(with(file, "")).size(), 1U) << file;
  for (const std::string file : {"README.md", "LICENSE", ".clang-tidy", "db/pid"})
    EXPECT_TRUE(strays_at_the_top(with(file, "")).empty()) << file;
}

TEST(HouseRules, AMachinePathIsNoticed) {
  for (const std::string folder : {"work", "root"}) {
    const std::string start = "/" + folder + "/";
    for (const std::string before : {"", " ", "\"", "'", "=", ": ", "`", "("}) {
      const std::string text = std::string("one\n").append(before).append(start).append("x\n");
      const auto found = machine_paths(with("README.md", text));
      ASSERT_EQ(found.size(), 1U) << before << start;
      EXPECT_EQ(found[0].line, 2);
    }
  }
}

TEST(HouseRules, ALongLineOfTheMapPageIsNoticed) {
  const std::string long_line = "first\n" + std::string(131, 'x') + "\n";
  const auto found = long_lines(with("server/page/src/main.ts", long_line));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].line, 2);
  EXPECT_TRUE(long_lines(with("server/page/src/words.ts", long_line)).empty());
  EXPECT_TRUE(long_lines(with("README.md", long_line)).empty());
}

TEST(HouseRules, ATreeIsReadFromTheDiskWithoutBuilds) {
  const auto root = std::filesystem::path(::testing::TempDir()) / "leda-made-up-tree";
  std::filesystem::remove_all(root);
  for (const std::string folder : {"solver", "build/release", ".git"})
    std::filesystem::create_directories(root / folder);
  std::ofstream(root / "solver/a.cpp") << include("db/store.hpp");
  std::ofstream(root / "build/release/b.cpp") << include("db/store.hpp");
  std::ofstream(root / ".git/utils") << "";
  const SourceTree tree = read_source_tree(root);
  std::filesystem::remove_all(root);
  ASSERT_EQ(tree.size(), 1U);
  EXPECT_EQ(all_breaches(tree).size(), 1U);
}

}  // namespace
}  // namespace leda::architecture
