// SPDX-License-Identifier: MIT
// Prints a program organization unit as text or XML. The XML conforms to PLCopen's TC6 schema 2.01 and uses its order
// of elements. The date in the file is constant, so that the same input yields the same file.
#include "emit/structured_text/unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <ostream>
#include <sstream>
#include <string_view>
#include <utility>

#include "emit/wrapped_text.hpp"
#include "support/xml_text.hpp"

namespace grafverif::structured_text {

namespace {

struct SectionWords {
    Section section = Section::Local;
    std::string_view text = {}, xml = {};
};

constexpr std::array sections = {
    SectionWords{Section::Input, "VAR_INPUT", "<inputVars>"},
    SectionWords{Section::Output, "VAR_OUTPUT", "<outputVars>"},
    SectionWords{Section::Constant, "VAR CONSTANT", "<localVars constant=\"true\">"},
    SectionWords{Section::Local, "VAR", "<localVars>"},
};

std::string_view word_of(const Unit& unit) { return unit.is_program ? "PROGRAM" : "FUNCTION_BLOCK"; }

/// Prints the comment, the first line and the variables.
void print_declaration(const Unit& unit, const DialectRow& dialect, std::ostream& out) {
    std::istringstream lines(comment_text(unit.comment));
    for (std::string line; std::getline(lines, line);) out << "(* " << line << " *)\n";
    out << word_of(unit) << ' ' << dialect.quote << unit.name << dialect.quote << '\n' << dialect.attributes;
    for (const SectionWords& words : sections) {
        bool open = false;
        for (const UnitVariable& variable : unit.variables) {
            if (variable.section != words.section) continue;
            if (!std::exchange(open, true)) out << words.text << '\n';
            out << "    " << variable.name << " : " << variable.type;
            if (!variable.initial.empty()) out << " := " << variable.initial;
            out << ';';
            if (!variable.comment.empty()) out << "   (* " << comment_text(variable.comment) << " *)";
            out << '\n';
        }
        if (open) out << "END_VAR\n";
    }
}

void print_text(const Unit& unit, const DialectRow& dialect, std::ostream& out) {
    print_declaration(unit, dialect, out);
    out << dialect.begin << '\n' << unit.body << "\nEND_" << word_of(unit) << '\n';
}

/// Returns an identifier for the file, which depends only on the name: two 64-bit FNV-1a hashes with different initial
/// values.
std::string file_id(std::string_view name) {
    std::array<std::uint64_t, 2> halves = {0xcbf29ce484222325, 0x84222325cbf29ce4};
    for (std::uint64_t& half : halves)
        for (const char c : name) half = (half ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    const std::string digits = fmt::format("{:016x}{:016x}", halves[0], halves[1]);
    return fmt::format("{{{}-{}-{}-{}-{}}}", digits.substr(0, 8), digits.substr(8, 4), digits.substr(12, 4),
                       digits.substr(16, 4), digits.substr(20));
}

/// Prints a file of a TwinCAT project. The texts contain no `]]>`, because names have only letters, digits and `_`.
void print_pou_file(const Unit& unit, const DialectRow& dialect, std::ostream& out) {
    out << "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<TcPlcObject Version=\"1.1.0.1\">\n  <POU Name=\"" << unit.name
        << "\" Id=\"" << file_id(unit.name) << "\" SpecialFunc=\"None\">\n    <Declaration><![CDATA[";
    print_declaration(unit, dialect, out);
    out << "]]></Declaration>\n    <Implementation>\n      <ST><![CDATA[" << unit.body
        << "]]></ST>\n    </Implementation>\n  </POU>\n</TcPlcObject>\n";
}

std::string data(std::string_view text) {
    std::string xml;
    escape_xml(text, xml);
    return xml;
}

/// Returns the text as XHTML, as required for documentation and bodies.
std::string xhtml(std::string_view text) {
    return "<xhtml xmlns=\"http://www.w3.org/1999/xhtml\">" + data(text) + "</xhtml>";
}

void print_variable(const UnitVariable& variable, std::ostream& out) {
    out << "            <variable name=\"" << attribute_xml(variable.name) << "\">\n              <type>";
    if (variable.derived) out << "<derived name=\"" << attribute_xml(variable.type) << "\"/>";
    else out << '<' << variable.type << "/>";
    out << "</type>\n";
    if (!variable.initial.empty())
        out << "              <initialValue><simpleValue value=\"" << attribute_xml(variable.initial)
            << "\"/></initialValue>\n";
    if (!variable.comment.empty())
        out << "              <documentation>" << xhtml(variable.comment) << "</documentation>\n";
    out << "            </variable>\n";
}

void print_interface(const Unit& unit, std::ostream& out) {
    out << "        <interface>\n";
    for (const SectionWords& words : sections) {
        bool open = false;
        for (const UnitVariable& variable : unit.variables) {
            if (variable.section != words.section) continue;
            if (!std::exchange(open, true)) out << "          " << words.xml << '\n';
            print_variable(variable, out);
        }
        const std::string_view tag = words.xml.substr(1, words.xml.find_first_of(" >") - 1);
        if (open) out << "          </" << tag << ">\n";
    }
    out << "          <documentation>" << xhtml(unit.comment) << "</documentation>\n        </interface>\n";
}

void print_plcopen(const Unit& unit, std::ostream& out) {
    const std::string name = attribute_xml(unit.name);
    out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
           "<project xmlns=\"http://www.plcopen.org/xml/tc6_0201\">\n"
           "  <fileHeader companyName=\"\" productName=\"grafverif\" productVersion=\"1\" "
           "creationDateTime=\"2000-01-01T00:00:00\"/>\n"
           "  <contentHeader name=\""
        << name << "\">\n    <coordinateInfo>\n";
    for (const char* language : {"fbd", "ld", "sfc"})
        out << "      <" << language << "><scaling x=\"1\" y=\"1\"/></" << language << ">\n";
    out << "    </coordinateInfo>\n  </contentHeader>\n  <types>\n    <dataTypes/>\n    <pous>\n"
        << "      <pou name=\"" << name << "\" pouType=\"" << (unit.is_program ? "program" : "functionBlock")
        << "\">\n";
    print_interface(unit, out);
    out << "        <body>\n          <ST>" << xhtml("\n" + unit.body) << "</ST>\n        </body>\n      </pou>\n"
        << "    </pous>\n  </types>\n  <instances><configurations/></instances>\n</project>\n";
}

}  // namespace

std::string comment_text(std::string text) {
    for (const std::string_view mark : {"(*", "*)"})
        for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at))
            text.insert(at + 1, " ");
    return text;
}

void print(const Unit& unit, Form form, const DialectRow& dialect, std::ostream& out) {
    Unit wrapped = unit;
    std::ostringstream body;
    print_wrapped(body, unit.body, "(*");
    wrapped.body = std::move(body).str();
    switch (dialect.file) {
    case FileForm::PouFile: return print_pou_file(wrapped, dialect, out);
    case FileForm::Source: return print_text(wrapped, dialect, out);
    case FileForm::Standard: break;
    }
    if (form == Form::Text) print_text(wrapped, dialect, out);
    else print_plcopen(wrapped, out);
}

}  // namespace grafverif::structured_text
