// The files of deploy/ as the programs read them that they are for.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>

#include "tests/server/temporary_folder.hpp"
#include "tests/service/leda_process.hpp"

namespace leda::tests {
namespace {

std::string text_of(const std::string& name) {
  std::ifstream in(std::string(LEDA_SOURCE_DIR) + "/deploy/" + name);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(DeployFiles, SystemdAcceptsTheUnit) {
  const TemporaryFolder folder;
  const auto unit = folder.path() / "leda.service";
  const std::string text =
      std::regex_replace(text_of("leda.service"), std::regex("/usr/local/bin/leda"), LEDA_PROGRAM);
  ASSERT_NE(text.find(std::string("ExecStart=") + LEDA_PROGRAM), std::string::npos);
  std::ofstream(unit) << text;
  const auto said = run_program({"systemd-analyze", "verify", "--man=no", unit.string()});
  if (!said) GTEST_SKIP() << "systemd-analyze is not installed";
  EXPECT_EQ(said->exit_code, 0) << said->errors;
  EXPECT_EQ(said->errors.find("leda.service:"), std::string::npos) << said->errors;
}

TEST(DeployFiles, NginxAcceptsTheSite) {
  if (!run_program({"/usr/sbin/nginx", "-v"})) GTEST_SKIP() << "nginx is not installed";
  const TemporaryFolder folder;
  const auto key = (folder.path() / "key").string(), cert = (folder.path() / "cert").string();
  const auto made =
      run_program({"openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "1",
                   "-subj", "/CN=leda.example.org", "-keyout", key, "-out", cert});
  if (!made) GTEST_SKIP() << "openssl is not installed";
  ASSERT_EQ(made->exit_code, 0) << made->errors;
  std::string site = text_of("nginx.conf");
  site = std::regex_replace(site, std::regex("ssl_certificate /[^;]+"), "ssl_certificate " + cert);
  site = std::regex_replace(site, std::regex("ssl_certificate_key /[^;]+"),
                            "ssl_certificate_key " + key);
  const auto main = folder.path() / "nginx.conf";
  std::ofstream(main) << "pid " << (folder.path() / "pid").string() << ";\nevents {}\nhttp {\n"
                      << site << "}\n";
  const auto said = run_program({"/usr/sbin/nginx", "-t", "-q", "-p", folder.path().string(), "-e",
                                 (folder.path() / "errors").string(), "-c", main.string()});
  ASSERT_TRUE(said);
  EXPECT_EQ(said->exit_code, 0) << said->errors;
}

TEST(DeployFiles, TheContainerHasEveryLibraryOfThePrograms) {
  const std::string container = text_of("Containerfile");
  // Those that Leda links itself; what they need in turn comes with their packages.
  const std::vector<std::pair<std::string, std::string>> packages = {
      {"libcpp-httplib.so", "libcpp-httplib0.11"},
      {"libfmt.so", "libfmt9"},
      {"libgdal.so", "libgdal32"},
      {"libhdf5_serial.so", "libhdf5-103-1"},
      {"libhwy.so", "libhwy1"},
      {"libnlopt.so", "libnlopt0"},
      {"libspdlog.so", "libspdlog1.10"},
      {"libsqlite3.so", "libsqlite3-0"},
      {"libcrypto.so", "libssl3"},
      {"libprometheus-cpp-core.so", "libprometheus-cpp-core1.0"}};
  const std::string commands = std::string(LEDA_PROGRAM) + "-commands";
  const auto own = run_program({"readelf", "-d", LEDA_PROGRAM, commands});
  if (!own) GTEST_SKIP() << "readelf is not installed";
  if (std::regex_search(own->text, std::regex("lib[a-z]+san\\."))) {
    GTEST_SKIP() << "built with a sanitizer: what it links stands in no container";
  }
  const std::regex needed("\\(NEEDED\\).*\\[([^\\]]+)\\]");
  int found = 0;
  for (std::sregex_iterator at(own->text.begin(), own->text.end(), needed), end; at != end; ++at) {
    const std::string library = (*at)[1];
    if (std::regex_search(library, std::regex("^(libc|libm|libstdc\\+\\+|libgcc_s|ld-linux.*)\\.")))
      continue;
    const auto known = std::find_if(packages.begin(), packages.end(), [&](const auto& entry) {
      return library.starts_with(entry.first);
    });
    ASSERT_NE(known, packages.end()) << library << " is of no package of the container";
    EXPECT_NE(container.find(known->second), std::string::npos) << known->second;
    ++found;
  }
  EXPECT_GE(found, 8);
}

}  // namespace
}  // namespace leda::tests
