#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "tests/support/program.hpp"
#include "tests/support/well_formed.hpp"

/// `mixcmp report` as a user calls it.
namespace mixcmp::test::report_command_test {
namespace {

using nlohmann::json;

class Report : public ProgramTest {
protected:
  void write_scene(const std::string& system = "lanes = 4\nreferences = 1\n",
                   const std::string& data = "count = 120\n") {
    write("scene.toml",
          "[comparison]\nname = \"spheres\"\n"
          "f = \"(cxi - cxj)^2 + (cyi - cyj)^2 + (czi - czj)^2\"\ng = \"(ri + rj)^2\"\n"
          "[inputs]\n\"c*\" = { range = [0, 100] }\n\"r*\" = { range = [0, 100] }\n"
          "[reference]\nformat = \"s24e8\"\n[reduced]\nformat = \"s8e8\"\n[system]\n" +
              system + "[data]\nitems = \"uniform_spheres\"\nradius_max = 40\nseed = 1\n" +
              "pairs = \"all\"\n" + data);
  }

  std::string page(const std::string& arguments, int exit_code = 0) {
    const Outcome run = mixcmp("report scene.toml -o page.html " + arguments);
    EXPECT_EQ(run.exit_code, exit_code) << run.output;
    return read("page.html");
  }

  /// Whether the page's table of undecided comparisons has this row.
  static std::string row_of(const json& profile, std::size_t k) {
    std::string row;
    for (const json& scheme : profile.at("recomputation_rates")[0].at("schemes")) {
      if (scheme.at("scheme") == "lanes_alone") continue;
      const json& counts = scheme.at("precisions").at(k);
      if (row.empty()) {
        row = fmt::format("<td class=\"number\">{}</td>", counts.at("precision").get<int>());
      }
      row += fmt::format("<td class=\"number\">{}</td>", counts.at("undecided").get<int>());
    }
    return row;
  }
};

TEST_F(Report, ShowsTheNumbersThatTheVerbsPrint) {
  write_scene();
  const std::string html = page("--without plan,waves");
  const json profile = json::parse(mixcmp("profile scene.toml --json").output);
  for (const std::size_t k : {0, 4, 20}) {
    EXPECT_NE(html.find(row_of(profile, k)), std::string::npos) << row_of(profile, k);
  }
  const json check = json::parse(mixcmp("check scene.toml --json").output);
  const auto& generated = check.at("generate");
  EXPECT_NE(html.find(generated.at("top").get<std::string>()), std::string::npos);
  const json& lane = generated.at("lane_groups")[0];
  EXPECT_NE(
      html.find(fmt::format("{} cycles from the operands", lane.at("latency_cycles").get<int>())),
      std::string::npos);
  EXPECT_NE(html.find(lane.at("decision").get<std::string>()), std::string::npos);
  EXPECT_NE(html.find("machine-checked"), std::string::npos);
}

/// Without ranges there is no lane in fixed point, and no constant bound.
TEST_F(Report, ABoundThatDoesNotExistIsInNoTableAndItsReasonIsTold) {
  write("data.csv", "a,b,c,d\n1,2,3,4\n5,6,7,8\n9,8,7,6\n");
  write("scene.toml",
        "[comparison]\nname = \"bare\"\nf = \"a * b\"\ng = \"c * d\"\n"
        "[reference]\nformat = \"binary32\"\n[reduced]\nformat = \"s12e8\"\n"
        "[system]\nlanes = 1\nreferences = 1\n[data]\nfile = \"data.csv\"\n");
  const std::string html = page("--without plan,waves");
  EXPECT_NE(html.find("<td>relative</td><td>yes</td>"), std::string::npos) << html;
  for (const char* bound : {"constant", "fixed_norm", "fixed_constant", "block_norm"}) {
    EXPECT_EQ(html.find(fmt::format("<td>{}</td>", bound)), std::string::npos) << bound;
    EXPECT_EQ(html.find(fmt::format("<th class=\"number\">{}</th>", bound)), std::string::npos);
    EXPECT_NE(html.find(fmt::format("{}: ", bound)), std::string::npos) << bound;
  }
}

TEST_F(Report, IsOneWellFormedFileThatLoadsNothing) {
  write_scene();
  std::string html = page("--without plan,waves");
  EXPECT_EQ(fault_of_markup(html), "");
  const std::string name_space = "http://www.w3.org/2000/svg";
  for (std::size_t at = 0; (at = html.find(name_space)) != std::string::npos;) {
    html.erase(at, name_space.size());
  }
  for (const char* loaded : {"http", "src=", "@import", "url(", "<link"}) {
    EXPECT_EQ(html.find(loaded), std::string::npos) << loaded;
  }
  EXPECT_EQ(html.find(path("").string()), std::string::npos) << "a path of this machine";
}

TEST_F(Report, TheSameInputGivesTheSameBytes) {
  write_scene();
  const std::string first = page("--without plan");
  EXPECT_EQ(first, page("--without plan"));
  EXPECT_NE(first.find("was decided by the lane in"), std::string::npos);
}

TEST_F(Report, WithoutReferencesAComparisonOfTheWavesStaysUndecided) {
  write_scene("lanes = 2\nreferences = 0\n");
  const std::string html = page("--without profile,plan");
  EXPECT_EQ(html.find("decided all"), std::string::npos);
  EXPECT_NE(html.find("nothing decides it, since the system has no reference"), std::string::npos);
  EXPECT_NE(html.find("without references, stay undecided"), std::string::npos);
  EXPECT_NE(html.find("lanes decide in s8e8 where that is certainly right, and leave the rest"),
            std::string::npos);
  write_scene();
  EXPECT_NE(page("--without profile,plan").find("it came back from a reference after"),
            std::string::npos);
  write_scene("lanes = 2\nreferences = 0\n", "count = 3\n");
  EXPECT_NE(page("--without profile,plan").find("The lane decided all 3 that were simulated."),
            std::string::npos);
}

TEST_F(Report, ShowsLanesInGroupsAndFollowsOneOfThem) {
  write_scene("lanes = 4\nreferences = 1\nlanes_per_group = 2\n");
  const std::string html = page("--without profile,plan");
  EXPECT_NE(html.find("p_L = 4 in groups of 2 in lock step, p_H = 1."), std::string::npos);
  EXPECT_NE(html.find("it came back from a reference after"), std::string::npos);
}

TEST_F(Report, ShowsAPairwiseEngineAsItIsBuilt) {
  write_scene("lanes = 4\nreferences = 1\n[engine]\nkind = \"pairwise\"\n");
  for (const char* lanes : {"q13", "s8e8"}) {
    const std::string html = page(std::string("--without profile,plan --format ") + lanes);
    EXPECT_EQ(fault_of_markup(html), "");
    EXPECT_EQ(html.find("The conversion of an item") != std::string::npos,
              lanes == std::string("q13"));
    EXPECT_NE(html.find(fmt::format("The top module spheres_{}_4x1_pairwise", lanes)),
              std::string::npos);
    EXPECT_NE(html.find("from the words of two items to the verdict"), std::string::npos);
    EXPECT_NE(html.find("and one reference, without the engine, simulated"), std::string::npos);
    EXPECT_EQ(html.find("crossbar"), std::string::npos);
  }
}

TEST_F(Report, ShowsTheSecondTierOfAnEngine) {
  write_scene("lanes = 4\nreferences = 1\n[engine]\nkind = \"pairwise\"\n");
  const std::string html = page("--without profile,plan --format q7 --set second_tier.format=q13");
  EXPECT_EQ(fault_of_markup(html), "");
  EXPECT_NE(html.find("The second tier, a lane in q13"), std::string::npos);
  EXPECT_NE(html.find("one lane in q7 and one reference, without the engine"), std::string::npos);
}

TEST_F(Report, WithoutATableThePlanIsOnPredictedAreas) {
  write_scene(
      "lanes = 4\nreferences = 1\nslack = 0.95\noperands = \"refetched\"\nlanes_per_group = 1\n"
      "counters = \"none\"\n[engine]\nkind = \"none\"\n");
  const std::string html =
      page("--without profile,front,waves --set reference.initiation_interval=1");
  EXPECT_EQ(fault_of_markup(html), "");
  EXPECT_EQ(html.find("% of the device"), std::string::npos) << "the front";
  EXPECT_NE(html.find("The best plan at each precision"), std::string::npos);
  EXPECT_NE(html.find("Note: areas are predicted; mixcmp optimise measures"), std::string::npos);
  EXPECT_NE(html.find("the system around the lanes: operands refetched, no counters"),
            std::string::npos);
}

TEST_F(Report, SaysWhatIsMissingAndTheCommandThatMakesIt) {
  write_scene();
  std::filesystem::create_directories(path("characterisation"));
  write("characterisation/scene-virtex6-lx760.csv", "no table\n");
  const Outcome run = mixcmp("report scene.toml -o page.html --without profile,front,waves");
  EXPECT_EQ(run.exit_code, 3) << run.output;
  EXPECT_NE(run.output.find("not done: plan: "), std::string::npos) << run.output;
  const std::string html = read("page.html");
  EXPECT_NE(html.find("<code>mixcmp characterise scene.toml</code>"), std::string::npos);
  EXPECT_EQ(html.find("--table"), std::string::npos) << "an option that nobody typed";
}

TEST_F(Report, ThePageIsTheSameFromAnyFolderAlsoWhereSectionsAreMissing) {
  write_scene("lanes = \"auto\"\nreferences = \"auto\"\n");
  for (const std::string& scene : {std::string("scene.toml"), path("scene.toml").string()}) {
    const Outcome run = mixcmp("report '" + scene + "' -o page.html --without profile,plan,front");
    EXPECT_EQ(run.exit_code, 3) << run.output;
    const std::string html = read("page.html");
    EXPECT_EQ(html.find(path("").string()), std::string::npos);
    EXPECT_EQ(html.find("-o plan.toml"), std::string::npos) << "a second command";
    if (scene == "scene.toml") write("first.html", html);
    EXPECT_EQ(html, read("first.html"));
  }
}

/// The points are those that `optimise` prints, and need no table. Given keys leave little to
/// search.
TEST_F(Report, DrawsTheFrontThatOptimiseFinds) {
  write_scene(
      "operands = \"carried\"\noperand_memory = \"logic\"\nrequest_beats = 1\nlanes_per_group = 1\n"
      "counters = \"none\"\n[engine]\nkind = \"none\"\n");
  const std::string keys =
      "--set reference.initiation_interval=1 --set 'comparison.f=abs(cxi - cxj)' "
      "--set 'comparison.g=ri + rj'";
  const std::string html = page("--without profile,waves " + keys, 3);
  EXPECT_EQ(fault_of_markup(html), "");
  const Outcome run = mixcmp("optimise scene.toml --predict-only --json " + keys);
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const json front = json::parse(run.output.substr(run.output.find('{'))).at("front");
  ASSERT_EQ(front.size(), 5U);
  for (const json& point : front) {
    const std::string share =
        fmt::format("{:g} % of the device\nL = {}\np_L = {}, p_H = {}\n",
                    100 * point.at("share").get<double>(), point.at("precision").get<int>(),
                    point.at("lanes").get<int>(), point.at("references").get<int>());
    EXPECT_NE(html.find(share), std::string::npos) << share;
    const bool is_marked = html.find("knee: " + share) != std::string::npos;
    EXPECT_EQ(is_marked, point.at("is_knee").get<bool>()) << share;
  }
}

TEST_F(Report, WithoutASystemTheOtherSectionsAreThere) {
  write_scene("lanes = \"auto\"\nreferences = \"auto\"\n");
  const Outcome run = mixcmp("report scene.toml -o page.html --without plan --json");
  EXPECT_EQ(run.exit_code, 3) << run.output;
  const json report = json::parse(run.output.substr(0, run.output.rfind('}') + 1));
  EXPECT_EQ(report.at("sections").size(), 6u);
  const std::string missing = report.at("not_done")[0];
  EXPECT_EQ(missing.rfind("system: ", 0), 0u) << missing;
  const std::string html = read("page.html");
  EXPECT_EQ(fault_of_markup(html), "");
  EXPECT_NE(html.find("mixcmp report spheres_plan.toml"), std::string::npos);
  EXPECT_NE(html.find("<circle"), std::string::npos);
}

TEST_F(Report, RefusesToReplaceItsInput) {
  write_scene();
  expect_refused("report scene.toml -o scene.toml", "would be written over");
  expect_refused("report scene.toml --without everything", "everything");
  expect_refused("report nowhere.toml", "nowhere.toml");
  EXPECT_NE(read("scene.toml").find("[comparison]"), std::string::npos);
}

/// The page in Chromium, at a width and in a colour scheme, and the findings of a script inside it.
class ReportInBrowser : public Report {
protected:
  void SetUp() override {
    if (shell("command -v chromium").exit_code != 0) {
      GTEST_SKIP() << "chromium is not installed (apt-get install chromium)";
    }
  }

  /// Text that stands in an attribute.
  static std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
      result += c == '&' ? "&amp;" : c == '"' ? "&quot;" : std::string(1, c);
    }
    return result;
  }

  /// Chromium has no windows as narrow as a phone: the page is in a frame.
  json look(std::string html, int width, const std::string& scheme) {
    html.insert(html.find("<body>") + 6, R"(<script>
var faults = [];
addEventListener("error", function (event) { faults.push(event.message); });
addEventListener("load", function () {
  function tip() { var box = document.getElementById("tip"); return box.hidden ? "" : box.textContent; }
  var point = document.querySelector(".series .point");
  point.scrollIntoView();
  point.dispatchEvent(new PointerEvent("pointermove", {bubbles: true, pointerType: "mouse"}));
  var pointed = tip();
  var key = new KeyboardEvent("keydown", {key: "ArrowRight", bubbles: true});
  document.querySelector("svg.chart").dispatchEvent(key);
  parent.document.documentElement.dataset.found = JSON.stringify({
    faults: faults, pointed: pointed, keyed: tip(),
    width: innerWidth, content: document.documentElement.scrollWidth,
    paper: getComputedStyle(document.body).backgroundColor});
});
</script>)");
    write("frame.html", fmt::format("<!DOCTYPE html><html><body><iframe srcdoc=\"{}\" width=\"{}\" "
                                    "height=\"800\"></iframe></body></html>",
                                    escaped(html), width));
    const Outcome run = shell(fmt::format(
        "cd '{0}' && HOME='{0}' timeout 60 chromium --headless=new --no-sandbox --disable-gpu "
        "--blink-settings=preferredColorScheme={1} --dump-dom file://{0}/frame.html 2>/dev/null",
        directory_.path().string(), scheme));
    const std::string name = "data-found=\"";
    const std::size_t begin = run.output.find(name);
    if (begin == std::string::npos) return {};
    const std::size_t first = begin + name.size();
    std::string found = run.output.substr(first, run.output.find('"', first) - first);
    for (std::size_t at = 0; (at = found.find("&quot;")) != std::string::npos;) {
      found.replace(at, 6, "\"");
    }
    return json::parse(found);
  }
};

TEST_F(ReportInBrowser, FitsBothWidthsInBothSchemesAndShowsTips) {
  write_scene();
  const std::string html = page("--without plan,waves");
  std::string papers;
  for (const auto& [width, scheme] : {std::pair(1280, "1"), std::pair(390, "0")}) {
    const json found = look(html, width, scheme);
    ASSERT_FALSE(found.empty()) << width;
    EXPECT_EQ(found.at("faults").size(), 0u) << found;
    EXPECT_EQ(found.at("width"), width);
    EXPECT_LE(found.at("content"), width) << "scrolls sideways";
    EXPECT_NE(found.at("pointed").get<std::string>().find("L = 4"), std::string::npos) << found;
    EXPECT_NE(found.at("keyed").get<std::string>().find("L = 5"), std::string::npos) << found;
    EXPECT_NE(found.at("paper"), papers) << "one colour in both schemes";
    papers = found.at("paper");
  }
}

}  // namespace
}  // namespace mixcmp::test::report_command_test
