// A server with tokens, as a ministry's network would reach it.

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "tests/server/temporary_folder.hpp"
#include "tests/service/leda_process.hpp"

namespace leda::tests {
namespace {

std::string simulate_request() {
  return R"({"inputs": {"case": {
    "name": "small", "ground": [[0, 10], [40, 10], [60, 2], [90, 2]], "base_m": 0,
    "layers": [{"material": "clay"}],
    "materials": {"clay": {"unit_weight_kN_m3": 17, "shear_modulus_kPa": 2000,
                           "poisson_ratio": 0.4, "peak_strength_kPa": 60}},
    "trigger": {"kind": "undrained"}, "resolution": {"cell_m": 2, "particles_per_cell": 4},
    "stop": {"max_time_s": 2}}}})";
}

std::string read_text(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// What `leda token` prints: the token, and beside it the line for the file.
struct Made {
  std::string token, line;
};

Made made_by_leda(const std::string& name, const std::string& role) {
  const Output ended = run_leda({"token", name, "--role", role});
  EXPECT_EQ(ended.exit_code, 0) << ended.errors;
  const auto at = ended.errors.find('\n') + 1;
  return {ended.text.substr(0, ended.text.find('\n')),
          ended.errors.substr(at, ended.errors.find('\n', at) - at)};
}

class TokensOfAServer : public testing::Test {
 protected:
  TokensOfAServer() {
    std::ofstream(folder.path() / "tokens") << reader.line << "\n# comment\n"
                                            << submitter.line << "\n"
                                            << admin.line << "\n";
    server = std::make_unique<LedaServer>(
        folder.path() / "data",
        std::vector<std::string>{"--tokens", (folder.path() / "tokens").string()});
  }

  int status(const std::string& method, const std::string& path, const std::string& token,
             const std::string& body = "") {
    httplib::Client client(server->url());
    if (!token.empty()) client.set_bearer_token_auth(token);
    const auto answer = method == "GET"      ? client.Get(path)
                        : method == "DELETE" ? client.Delete(path)
                                             : client.Post(path, body, "application/json");
    return answer ? answer->status : 0;
  }

  TemporaryFolder folder;
  Made reader = made_by_leda("rita", "read"), submitter = made_by_leda("sam", "submit"),
       admin = made_by_leda("ada", "admin");
  std::unique_ptr<LedaServer> server;
  const std::string execution = "/processes/simulate-section/execution";
};

TEST_F(TokensOfAServer, OnlyTheProbesAnswerWithoutOne) {
  EXPECT_EQ(status("GET", "/healthz", ""), 200);
  EXPECT_EQ(status("GET", "/readyz", ""), 200);
  for (const char* path : {"/", "/api", "/jobs", "/metrics", "/collections", "/nothing",
                           "/rasters/none", "/collections/sections/items"}) {
    EXPECT_EQ(status("GET", path, ""), 401) << path;
    EXPECT_EQ(status("GET", path, "leda_wrong"), 401) << path;
  }
  httplib::Client client(server->url());
  EXPECT_EQ(client.Get("/jobs")->get_header_value("WWW-Authenticate"), "Bearer realm=\"leda\"");
}

TEST_F(TokensOfAServer, EachRoleMayDoItsPart) {
  EXPECT_EQ(status("GET", "/jobs", reader.token), 200);
  EXPECT_EQ(status("POST", execution, reader.token, simulate_request()), 403);
  EXPECT_EQ(status("DELETE", "/jobs/x", reader.token), 403);
  EXPECT_EQ(status("POST", "/rasters?name=x", reader.token, "x"), 403);
  EXPECT_EQ(status("POST", execution, submitter.token, simulate_request()), 201);
  EXPECT_EQ(status("POST", "/purge?older_than_days=1", submitter.token), 403);
  EXPECT_EQ(status("POST", "/purge?older_than_days=1", admin.token), 200);
  EXPECT_EQ(status("POST", "/purge?older_than_days=soon", admin.token), 400);
}

TEST_F(TokensOfAServer, NoTokenStandsInTheLog) {
  status("POST", execution, submitter.token, simulate_request());
  status("POST", execution, "leda_guessed", simulate_request());
  const std::string log = read_text(folder.path() / "data" / "server.log");
  EXPECT_NE(log.find("holder=sam"), std::string::npos) << log;
  EXPECT_EQ(log.find(submitter.token), std::string::npos);
  EXPECT_EQ(log.find("leda_guessed"), std::string::npos);
}

TEST(OtherAddresses, NeedTokensAndANameToBeReachedBy) {
  const TemporaryFolder folder;
  const std::string data = (folder.path() / "data").string();
  const Output open = run_leda({"serve", "--data", data, "--listen", "0.0.0.0:0"});
  EXPECT_EQ(open.exit_code, 2);
  EXPECT_NE(open.errors.find("LEDA_TOKENS"), std::string::npos) << open.errors;
  const Made admin = made_by_leda("ada", "admin");
  std::ofstream(folder.path() / "tokens") << admin.line << "\n";
  const std::string tokens = (folder.path() / "tokens").string();
  const Output nameless =
      run_leda({"serve", "--data", data, "--listen", "0.0.0.0:0", "--tokens", tokens});
  EXPECT_EQ(nameless.exit_code, 2);
  EXPECT_NE(nameless.errors.find("--public-url"), std::string::npos) << nameless.errors;
  std::ofstream(folder.path() / "bad") << "admin 123 ada\n";
  const Output bad =
      run_leda({"serve", "--data", data, "--tokens", (folder.path() / "bad").string()});
  EXPECT_EQ(bad.exit_code, 2);
  EXPECT_NE(bad.errors.find("line 1"), std::string::npos) << bad.errors;
}

}  // namespace
}  // namespace leda::tests
