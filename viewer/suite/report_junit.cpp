// JUnit XML.

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>

#include "viewer/base/text.h"
#include "viewer/suite/report.h"

namespace aomd::suite {
namespace {

bool failed(const Finished& each) {
  return each.result.outcome == Outcome::Differs || each.result.outcome == Outcome::Missed;
}

bool in_error(const Finished& each) { return !each.result.well() && !failed(each); }

void add_case(pugi::xml_node suite, const std::string& name, const Finished& each) {
  pugi::xml_node node = suite.append_child("testcase");
  node.append_attribute("classname") = name.c_str();
  node.append_attribute("name") = each.what->name.c_str();
  node.append_attribute("time") = scene::short_number(each.result.seconds).c_str();
  if (each.result.well()) return;
  pugi::xml_node problem = node.append_child(failed(each) ? "failure" : "error");
  problem.append_attribute("type") = std::string(outcome_word(each.result.outcome)).c_str();
  problem.append_attribute("message") = each.result.why.c_str();
}

void add_counts(pugi::xml_node node, const std::vector<Finished>& finished) {
  double seconds = 0;
  for (const Finished& each : finished) seconds += each.result.seconds;
  node.append_attribute("tests") = finished.size();
  node.append_attribute("failures") = std::count_if(finished.begin(), finished.end(), failed);
  node.append_attribute("errors") = std::count_if(finished.begin(), finished.end(), in_error);
  node.append_attribute("time") = scene::short_number(seconds).c_str();
}

}  // namespace

std::string report_junit(const Suite& suite, const std::vector<Finished>& finished) {
  const std::string name = printable(suite.file.stem().string());
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  pugi::xml_node all = document.append_child("testsuites");
  add_counts(all, finished);
  pugi::xml_node node = all.append_child("testsuite");
  node.append_attribute("name") = name.c_str();
  add_counts(node, finished);
  for (const Finished& each : finished) add_case(node, name, each);
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

}  // namespace aomd::suite
