// The page that shows a suite: what is in it, and, where Debian's chromium is installed, what it
// does there.

#include <gtest/gtest.h>

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>

#include "core/io/png.h"
#include "tests/support/io_helpers.h"
#include "viewer/suite/report.h"

namespace aomd::suite::suite_page_test {
namespace {

namespace fs = std::filesystem;

io::Image grey(int value) {
  io::Image image(64, 48);
  for (std::size_t i = 0; i < image.rgba.size(); ++i)
    image.rgba[i] = i % 4 == 3 ? 255 : static_cast<std::uint8_t>(value);
  return image;
}

/// A suite of five cases whose names say what became of them.
class SuitePage : public testing::Test {
 protected:
  SuitePage() {
    suite_.file = "parts.toml";
    suite_.baselines = folder_ / "";
    for (const char* name : {"good", "near", "far", "gone", "made"}) {
      Case& each = suite_.cases.emplace_back();
      each.name = name;
      each.size = {64, 48};
    }
    add(Outcome::Same, 0, 1);
    add(Outcome::Differs, 1, 0.9);
    add(Outcome::Differs, 1, 0.2);
    add(Outcome::Broken, 3, 1);
    add(Outcome::New, 0, 1);
    finished_[3].result.why = "</script><b>no \"mesh\"</b>";
    for (const char* name : {"good", "near", "far", "made"})
      io::write_png(folder_ / (std::string(name) + ".png").c_str(), grey(90));
    for (const std::size_t i : {1u, 2u}) {
      CaseResult& result = finished_[i].result;
      result.picture = folder_ / "result.png";
      result.difference = folder_ / "difference.png";
    }
    io::write_png(folder_ / "result.png", grey(100));
    io::write_png(folder_ / "difference.png", grey(200));
    page_ = report_page(suite_, finished_);
  }
  void add(Outcome outcome, int code, double worst_tile) {
    CaseResult result;
    result.outcome = outcome;
    result.exit_code = code;
    if (outcome == Outcome::Same || outcome == Outcome::Differs) {
      result.judged.emplace_back();
      result.judged[0].verdict.worst_tile = worst_tile;
      result.judged[0].verdict.same = outcome == Outcome::Same;
      result.judged[0].verdict.same_size = true;
      result.judged[0].verdict.tile = {32, 0, 32, 32};
    }
    finished_.push_back({&suite_.cases[finished_.size()], result});
  }

  /// What a line of JavaScript comes to once the page is there; chromium must be.
  std::string evaluated(const std::string& expression) const {
    std::ofstream(folder_ / "page.html")
        << page_ << "<script>setTimeout(() => { document.title = 'said: ' + (" << expression
        << ") + ';'; }, 50);</script>";
    const std::string command =
        "cd '" + (folder_ / "").string() +
        "' && HOME=$PWD chromium --headless --no-sandbox --disable-gpu --user-data-dir=profile "
        "--virtual-time-budget=5000 --dump-dom page.html >dom.txt 2>err.txt </dev/null";
    if (std::system(command.c_str()) != 0) return aomd::test::bytes_of(folder_ / "err.txt");
    const std::string dom = aomd::test::bytes_of(folder_ / "dom.txt");
    const std::size_t at = dom.find("said: ");
    return at == std::string::npos ? dom.substr(0, 2000)
                                   : dom.substr(at + 6, dom.find(';', at) - at - 6);
  }

  aomd::test::TemporaryFolder folder_;
  Suite suite_;
  std::vector<Finished> finished_;
  std::string page_;
};

TEST_F(SuitePage, IsOneFileThatAsksForNoOther) {
  for (const char* other : {"http:", "https:", "src=", "@import", "url(", "{{"})
    EXPECT_EQ(page_.find(other), std::string::npos) << other;
  const std::string png = "data:image/png;base64,iVBORw0KGgo";
  std::size_t pictures = 0;
  for (std::size_t at = page_.find(png); at != std::string::npos; at = page_.find(png, at + 1))
    ++pictures;
  EXPECT_EQ(pictures, 4u + 2u + 2u + 2u) << "baselines, results, differences, results as baselines";
}

TEST_F(SuitePage, NothingInItEndsItsScript) {
  EXPECT_EQ(page_.find("</script><b>"), std::string::npos);
  EXPECT_NE(page_.find("\\u003c/script>\\u003cb>no \\\"mesh\\\"\\u003c/b>"), std::string::npos);
}

/// The same in a browser.
class SuitePageShown : public SuitePage {
 protected:
  void SetUp() override {
    if (std::system("command -v chromium >/dev/null 2>&1") != 0) GTEST_SKIP() << "no chromium here";
  }
};

const std::string shown_names =
    "[...document.querySelectorAll('article')].map(e => e.dataset.name).join(' ')";
const std::string press =
    "(text => [...document.querySelectorAll('button')].find(e => e.textContent === text).click())";

TEST_F(SuitePageShown, TheWorstComesFirst) {
  EXPECT_EQ(evaluated(shown_names), "gone far near made good");
}

TEST_F(SuitePageShown, OutcomesAndNamesAreChosen) {
  EXPECT_EQ(evaluated(press + "('Problems') || " + shown_names), "gone far near");
  EXPECT_EQ(evaluated(press + "('same') || " + shown_names), "good");
  EXPECT_EQ(evaluated("(() => { const s = document.getElementById('search'); s.value = 'A'; "
                      "s.dispatchEvent(new Event('input')); return " +
                      shown_names + "; })()"),
            "far near made");
}

TEST_F(SuitePageShown, PicturesStandSideBySideAndTheTileIsMarked) {
  EXPECT_EQ(evaluated("[...document.querySelectorAll('[data-name=far] figcaption')]"
                      ".map(e => e.textContent).join(' ')"),
            "Baseline Result Difference");
  EXPECT_EQ(evaluated("[...document.querySelectorAll('img')].every(e => e.naturalWidth === 64)"),
            "true");
  EXPECT_EQ(evaluated("[...document.querySelectorAll('[data-name=far] .tile')].map(e => "
                      "e.style.left + ' ' + e.style.width).join(', ')"),
            "50% 50%, 50% 50%, 50% 50%");
}

TEST_F(SuitePageShown, TheSliderShowsSoMuchOfTheBaseline) {
  EXPECT_EQ(evaluated("(() => { " + press +
                      "('Slider'); const r = document.querySelector('[data-name=far] "
                      "input'); r.value = 25; r.dispatchEvent(new Event('input')); return "
                      "document.querySelectorAll('[data-name=far] img')[1].style.clipPath; })()"),
            "inset(0px 75% 0px 0px)");
}

TEST_F(SuitePageShown, BlinkingShowsOneAfterTheOther) {
  EXPECT_EQ(evaluated("(() => { " + press +
                      "('Blink'); const seen = new Set(); const look = () => "
                      "seen.add(document.querySelector('[data-name=far] "
                      "figcaption').textContent + document.querySelectorAll('[data-name=far] "
                      "img')[1].style.visibility); setInterval(look, 100); setTimeout(() => { "
                      "document.title = 'said: ' + [...seen].sort().join(' ') + ';'; }, 3000); "
                      "return ''; })()"),
            "Baseline Baselinevisible Resulthidden");
}

TEST_F(SuitePageShown, TextIsText) {
  EXPECT_EQ(evaluated("document.querySelector('[data-name=gone] .why').textContent.length"), "25");
  EXPECT_EQ(evaluated("document.querySelectorAll('b').length"), "0");
}

}  // namespace
}  // namespace aomd::suite::suite_page_test
