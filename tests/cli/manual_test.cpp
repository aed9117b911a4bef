#include <regex>
#include <set>

#include "cli/cli_test.h"

namespace relievo {
namespace {

class Manual : public CliTest {
 protected:
  std::string page(const std::vector<std::string>& of) const {
    std::vector<std::string> words = {"manual"};
    words.insert(words.end(), of.begin(), of.end());
    const Outcome outcome = relievo(words);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return outcome.out;
  }

  /// What bash offers after the words, the last of which may be half-written.
  std::string offered(const std::string& words, int last) {
    write("completions", page({"bash"}));
    write("try", "source ./completions\nCOMP_WORDS=(" + words + ")\nCOMP_CWORD=" +
                     std::to_string(last) + "\n_relievo\necho \"${COMPREPLY[*]}\" > offered\n");
    const std::string call = "cd '" + folder_.path().string() + "' && bash try";
    EXPECT_EQ(std::system(call.c_str()), 0);
    return read("offered");
  }
};

/// All long options in a text.
std::set<std::string> options_in(const std::string& text) {
  std::set<std::string> found;
  const std::regex option("--[a-z][a-z0-9-]+");
  for (auto i = std::sregex_iterator(text.begin(), text.end(), option); i != std::sregex_iterator();
       ++i)
    found.insert(i->str());
  return found;
}

TEST_F(Manual, PagesSayWhatHelpSays) {
  for (const std::string command : {"build", "batch", "check", "render", "segment", "sequence"}) {
    const std::string written = page({"man", command});
    const std::string text = std::regex_replace(written, std::regex(R"(\\-)"), "-");
    EXPECT_EQ(options_in(text), options_in(relievo({command, "--help"}).out)) << command;
    EXPECT_EQ(written.substr(0, 13), ".TH RELIEVO\\-") << command;
    EXPECT_NE(text.find("\nrelievo " + command), std::string::npos) << "no example of " << command;
    EXPECT_NE(page({"man"}).find("\\fB" + command + "\\fR"), std::string::npos) << command;
  }
}

TEST_F(Manual, PagesHoldNoRequestsByAccident) {
  const std::string text = page({"man", "build"});
  const std::set<std::string> requests = {".TH", ".SH", ".TP", ".nf", ".fi"};
  for (size_t at = text.find("\n."); at != std::string::npos; at = text.find("\n.", at + 1))
    EXPECT_TRUE(requests.count(text.substr(at + 1, 3))) << text.substr(at, 40);
}

TEST_F(Manual, BashOffersCommandsOptionsAndTheirValues) {
  EXPECT_EQ(offered("relievo ren", 1), "render\n");
  EXPECT_EQ(offered("relievo build --normal-", 2), "--normal-map --normal-y\n");
  EXPECT_EQ(offered("relievo build --method ''", 3), "approximate nonlinear\n");
  EXPECT_EQ(offered("relievo render --view s", 3), "side sheet\n");
  EXPECT_EQ(offered("relievo build --vertices ''", 3), "\n");
}

TEST_F(Manual, OtherShellsAreToldAllOptions) {
  const std::set<std::string> wanted = options_in(relievo({"segment", "--help"}).out);
  const std::string zsh = page({"zsh"});
  const std::string fish = page({"fish"});
  for (const std::string& option : wanted) {
    EXPECT_NE(zsh.find(option + "["), std::string::npos) << option;
    EXPECT_NE(fish.find(" -l " + option.substr(2) + " "), std::string::npos) << option;
  }
}

TEST_F(Manual, RefusesWhatThereIsNot) {
  expect_failure({"manual", "csh"}, 2, "csh");
  expect_failure({"manual", "man", "paint"}, 2, "paint");
}

}  // namespace
}  // namespace relievo
