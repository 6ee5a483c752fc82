// No text ever becomes a command line: programs are started with a list of arguments.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

namespace leda {
namespace {

namespace fs = std::filesystem;

bool calls_a_shell(const std::string& text) {
  static const std::regex call(R"((^|[^\w.:>])(std::)?(system|popen|wordexp|execlp|execvp)\()");
  return std::regex_search(text, call) || text.find("\"/bin/sh\"") != std::string::npos;
}

TEST(NoShell, IsCalledAnywhere) {
  int files = 0;
  for (const char* room : {"solver", "profiles", "db", "server"}) {
    const fs::path folder = fs::path(LEDA_SOURCE_DIR) / room;
    for (const auto& entry : fs::recursive_directory_iterator(
             folder, fs::directory_options::follow_directory_symlink)) {
      const auto ending = entry.path().extension();
      if (ending != ".cpp" && ending != ".hpp") continue;
      std::ifstream in(entry.path());
      const std::string text{std::istreambuf_iterator<char>(in), {}};
      EXPECT_FALSE(calls_a_shell(text)) << entry.path();
      ++files;
    }
  }
  EXPECT_GT(files, 100);
}

TEST(NoShell, IsNoticed) {
  for (const char* text : {"  system(\"ls\");", "int x = std::system(command.c_str());",
                           "FILE* f = popen(text, \"r\");", "execl(\"/bin/sh\", x);"}) {
    EXPECT_TRUE(calls_a_shell(text)) << text;
  }
  EXPECT_FALSE(calls_a_shell("file_system(x); of.system(y);"));
}

}  // namespace
}  // namespace leda
