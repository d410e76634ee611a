"""Each rule of the repository rejects a made-up fault."""

import shutil
import tempfile
import unittest
from pathlib import Path

from rules import advice, layers, magic_numbers, page_scripts, references, repository, wording
from rules.tree import Tree


class RuleTest(unittest.TestCase):
    """A test with made-up files."""

    FILES = {}

    def results(self, rule, files):
        """Returns what a rule yields for FILES with some of them replaced."""
        with tempfile.TemporaryDirectory() as folder:
            for name, text in {**self.FILES, **files}.items():
                Path(folder, name).parent.mkdir(parents=True, exist_ok=True)
                Path(folder, name).write_text(text, "utf-8")
            return [str(result) for result in rule(Tree(folder))]

    def check(self, rule, files, *expected):
        """Checks the faults that a rule yields."""
        self.assertEqual(sorted(self.results(rule, files)), sorted(expected))


class Wording(RuleTest):
    def test_wording_that_reads_as_translated(self):  # words are split, because this file must follow the rule, too
        for text, *expected in (
                ('/** Radius of the piece (mm). */\nthrow Error("there is no piece"); // none is left\n',),
                ("int r; ///< Of the piece\n", "a.cxx:1: begins a comment with a bare genitive: ///< Of t"),
                ('f("x is "\n  "no number");\n', "a.cxx:1: says what is not by: is no"),
                ("// Failures are to" "ld.\n", "a.cxx:1: is not plain English: to" "ld"),
                ("\nint nextCol" "our; // analyses of centers\n", "a.cxx:2: is not American spelling: col" "our")):
            self.check(wording.plain_english, {"a.cxx": text}, *expected)


class MagicNumbers(unittest.TestCase):
    """Reports of clang-tidy."""

    def is_fault(self, line, number, message="is a magic number"):
        return magic_numbers.is_fault(line, line.index(number) + 1, f"{number} {message}")

    def test_numbers_without_a_name(self):
        for line, number in (("if (share > 0.35)", "0.35"), ("cost = 40.0 + 7.0 * turns;", "40.0"),
                             ("options.band = 75.0;", "75.0"), ("f(a, 12.0);", "12.0")):
            self.assertTrue(self.is_fault(line, number), line)

    def test_numbers_that_need_no_name(self):
        for line, number in (("  double radius{ 2.5 };", "2.5"), ("Widened(const Box & box, double margin = 7.5);", "7.5"),
                             ("int rows = 12;", "12"), ("RequireParameter(step >= 0.2, ...", "0.2"),
                             ("options.progress(0.35);", "0.35"), ("progress.Part(text, 0.35, 1.0)", "0.35"),
                             ("values[5] = a;", "5"), ("word >> 20 & 63;", "20"), ("word >> 20 & 63;", "63"),
                             ("byte > 0xC2", "0xC2")):
            self.assertFalse(self.is_fault(line, number), line)

    def test_sources_that_do_not_compile(self):
        self.assertTrue(self.is_fault("int rows = 12;", "12", "use of an undeclared identifier"))


class Advice(RuleTest):
    """Two tools: Cutter, linked with Sheets through Knives, and Painter, linked with nothing."""

    FILES = {
        "Modules/Core/Sheets/itk-module.cmake": "itk_module(Sheets DEPENDS ITKCommon)\n",
        "Modules/Core/Knives/itk-module.cmake": "itk_module(Knives\n  DEPENDS Sheets)\n",
        "Applications/Cutter/CMakeLists.txt": "shapeton_add_tool(Cutter MODULES Knives)\n",
        "Applications/Painter/CMakeLists.txt": "shapeton_add_tool(Painter)\n",
        "Applications/Cutter/Cutter.xml":
            "<executable><parameters><integer><name>sheet</name><constraints><minimum>0</minimum><maximum>9</maximum>"
            "</constraints></integer><string-enumeration><name>shape</name><element>round</element>"
            "<element>square</element></string-enumeration></parameters></executable>",
        "Applications/Painter/Painter.xml":
            "<executable><parameters><string><name>color</name></string></parameters></executable>",
    }
    CUTTER, SHEETS = "Applications/Cutter/a.cxx", "Modules/Core/Sheets/src/a.cxx"

    def check_text(self, file, text, *expected):
        source = f"// --none\nconst char * text =\n  {text}; /* --none */ char c = '\"';\n"
        self.check(advice.accepted_advice, {file: source}, *(f"{file}:3: {fault}" for fault in expected))

    def test_accepted_advice(self):
        self.check_text(self.CUTTER, '"--sheet 3 or --shape" " round; --sheet takes one, --help more"')
        self.check_text(self.CUTTER, r'"use Painter (--color red), or \"--shape=square\""')
        self.check_text(self.SHEETS, r'"the parameter \"sheet\" = N or the parameter \"shape\" = round"')
        self.check_text(self.SHEETS, '"a -- b --color of a page"')  # libraries name parameters
        self.check_text("Modules/Core/Sheets/test/a.cxx", r'"the parameter \"length\""')

    def test_undeclared_options(self):
        message = "names the option --color, which no tool that may print it declares"
        self.check_text(self.CUTTER, '"a"\n  "b --color"', message)
        self.check_text(self.SHEETS, r'"the parameter \"color\""', message)
        message = "names the option --sheet, which Painter does not declare"
        self.check_text(self.CUTTER, '"Painter (--sheet 3)"', message)

    def test_rejected_values(self):
        self.check_text(self.SHEETS, r'"the parameter \"sheet\" = -1"', "names --sheet -1, which Cutter rejects")
        self.check_text(self.CUTTER, '"give --shape oval or --sheet 10"',
                        "names --shape oval, which Cutter rejects", "names --sheet 10, which Cutter rejects")


class References(RuleTest):
    def test_equations(self):
        files = {"Modules/A/B/include/b.h": "/** Text. \\equation{2.4} as a product. */\nint a();\n\n"
                                            "/** \\equation{3.10}\n *\n * \\equation{5.5} */\n",
                 "Modules/A/B/src/b.cxx": "/** \\equation{6.7} */\nint b;\n/**/ int c;\n/** \\equation{8.5} */\n",
                 "Applications/Tool/Tool.cxx": "/** \\equation{2.4} */\n"}
        self.check(references.equations, files)
        files["Modules/A/B/src/b.cxx"] = "/** \\equation{6.7} */\nint b;\n\n/** \\equation{2.4} */\n// \\equation{8.5}\n"
        self.check(references.equations, files,
                   "Modules/A/B/src/b.cxx:4: marks equation (2.4), which Modules/A/B/include/b.h marks",
                   "Modules: no comment marks equation (8.5)")

    def test_comments_of_a_group_only(self):
        text = ("/** A class. \\ingroup B */\nclass A;\n/** \\ingroup B */\nclass B;\n/** \\class C\n * \\ingroup B\n */\n"
                "class C;\n///@{\n/***/\n/** Text. */\n")
        self.check(references.group_only, {"Modules/A/B/include/b.h": text, "Modules/A/B/src/c.h": "/** \\ingroup B */"},
                   *(f"Modules/A/B/include/b.h:{line}: a comment contains only a group" for line in (3, 5)))

    def test_groups_of_other_modules(self):
        text = "int a;\n/** Text. \\ingroup Part */\nint b;\n/** Text. \\ingroup C */\nint c;\n"
        self.check(references.groups, {
            "Modules/A/B/include/b.h": "/** \\defgroup Part A part of B\n * \\ingroup B */\n",
            "Modules/A/B/src/b.cxx": text,
            "Modules/A/C/include/c.h": "/** Text.\n * \\ingroup Part */\nint a;\n/** Text. \\ingroup C */\n",
        }, "Modules/A/B/src/b.cxx:4: names the group C, which is not a group of its module",
            "Modules/A/C/include/c.h:1: names the group Part, which is not a group of its module")


class Repository(RuleTest):
    def test_good_links(self):
        self.check(repository.broken_links, {
            "Documentation/guide.md": "# A heading: with *marks*\ntext\n## Second_part 2 ##\n",
            "picture.png": "",
            "README.md":
                "[a](Documentation/guide.md) [b](https://example.org/x) [c](Documentation)\n"
                '![p](picture.png "title") <img src="picture.png">\n'
                "[h](Documentation/guide.md#a-heading-with-marks) [i](Documentation/guide.md#second_part-2)\n"
                "`[code](nowhere)`\n```\n[code](nowhere)\n```\n[r]: picture.png\n"})

    def test_broken_links(self):
        faults = {"nowhere.md": "missing file", "Documentation/guide.md#other": "missing heading",
                  "#none": "missing heading", "no.png": "missing file", "no.md": "missing file"}
        self.check(repository.broken_links, {
            "Documentation/guide.md": "# Heading\n[up](../../x.md)\n",
            "README.md": "[a](nowhere.md)\n[h](Documentation/guide.md#other)\n[s](#none)\n<img src=\"no.png\">\n"
                         "[r]: no.md\n"},
            "Documentation/guide.md:2: the link ../../x.md leaves the repository",
            *(f"README.md:{i}: the link {link} points to a {fault}" for i, (link, fault) in enumerate(faults.items(), 1)))

    def test_pages(self):
        files = dict.fromkeys(("Modules/Core/Low/itk-module.cmake", "Modules/Core/Low/README.md", "itk-module.cmake",
                               "Applications/Tool/CMakeLists.txt", "Applications/Tool/Testing/CMakeLists.txt"), "")
        files["Documentation/index.md"] = "[Low](../Modules/Core/Low/README.md)\n"
        self.check(repository.pages, files, "Applications/Tool: has no README.md",
                   "Documentation/index.md: has no link to Applications/Tool/README.md")
        files["Applications/Tool/README.md"] = ""
        files["Documentation/index.md"] += "[Tool](../Applications/Tool/README.md)\n"
        self.check(repository.pages, files)

    def test_source_of_data(self):
        files = {"Data/small.nrrd": ""}
        self.check(repository.pages, files, "Data/small.nrrd: Data/README.md does not state its source and license")
        self.check(repository.pages, {**files, "Data/README.md": "small.nrrd: made by hand, CC0\n"})

    def test_sizes(self):
        files = {"small": "x" * 1000000, "large": "x" * 1000001, "build/large": "x" * 1000001}
        self.check(repository.sizes, files, "large: has 1000001 bytes, more than 1 MB")

    def test_texts(self):  # words are split, because this file must follow the rule, too
        self.check(repository.texts, {"a.cmake": "set(x 1)\nset(y /home" "/somebody)\n", "picture.png": "\0/home" "/x"},
                   "a.cmake:2: contains a machine-specific path: /home" "/")
        notice = "Copy" "right ("
        self.check(repository.texts, {"LICENSE": notice, "a.cxx": notice}, f"a.cxx:1: contains a foreign license: {notice}")
        call = "MultiThreaderBase::New()" "->Parallelize"
        self.check(repository.texts, {"a.cxx": f"itk::{call}Array(0, n, body, nullptr);\n"},
                   f"a.cxx:1: has a loop that does not use shapetonParallelFor.h: {call}")
        thread = "std::thread other("
        self.check(repository.texts, {"Modules/a.cxx": f"{thread}work);\n", "Modules/test/a.cxx": f"{thread}work);\n"},
                   f"Modules/a.cxx:1: starts a thread without shapetonParallelFor.h: {thread}")
        pi = "M_" "PI"
        self.check(repository.texts, {"a.cxx": f"x = {pi};\n"}, f"a.cxx:1: does not use shapetonPi.h: {pi}")

    def test_option_tables(self):
        marker = "<!-- options VolumeGradientOptions: p -->\n"
        table = repository.options.expand_readme(marker)
        self.assertIn("| `--p` | 7 |", table)
        self.check(repository.option_tables, {"a.md": table})
        self.check(repository.option_tables, {"a.md": table.replace("7", "8")},
                   "a.md: has an old table of options: run CMake/options.py readme")

    def test_length_of_pages(self):
        for page, limit, kind in (("CHANGELOG.md", 400, "the changelog"), ("a/b.md", 800, "another page"),
                                  ("Modules/A/B/README.md", 350, "the page of a module"),
                                  ("Applications/Tool/README.md", 550, "the page of a tool"),
                                  ("Documentation/figures.md", 3700, "the page of figures")):
            self.check(repository.short_pages, {page: "x " * limit, "a.cxx": "x " * 5000})
            self.check(repository.short_pages, {page: "x " * (limit + 1)},
                       f"{page}: has {limit + 1} words; {kind} has at most {limit}")
        pages = {f"{i}.md": "x " * 800 for i in range(75)}
        self.check(repository.short_pages, pages)
        self.check(repository.short_pages, {**pages, "75.md": "x"}, "README.md: all pages have 60001 words, more than 60000")

    def test_failures_of_validations(self):
        table, page = f"{repository.TABLES}/a.csv", "Documentation/validation/a.md"
        files = {table: "section,value,\nA,1,pass\nA,2,FAIL\nB,3,FAIL (1 of 2)\n"}
        self.check(repository.stated_failures, {**files, page: "text\n[a](tables/a.csv)\n(2 failed)"})
        for text in ("", " (1 failed)", " failed"):
            self.check(repository.stated_failures, {**files, page: f"text\n[a](tables/a.csv){text}"},
                       f"{page}:2: must state that 2 rows of a.csv failed")
        self.check(repository.stated_failures, {table: "section\n", page: "[a](tables/a.csv) (2 failed)"},
                   f"{page}:1: must state that 0 rows of a.csv failed")
        self.check(repository.stated_failures, files, f"{table}: is not linked by a page of Documentation/validation")

    def test_length_of_tools(self):
        self.check(repository.short_tools, {"Applications/Tool/Tool.cxx": "x\n" * 150})
        self.check(repository.short_tools, {"Applications/Tool/Tool.cxx": "x\n" * 151},
                   "Applications/Tool/Tool.cxx: has 151 lines, more than 150; move code to a module")


def declaration(arguments):
    """Returns the text of an itk-module.cmake."""
    return f'set(DOCUMENTATION "Shapes (of things).")\nitk_module({arguments}\n  EXCLUDE_FROM_DEFAULT)\n'


def module_list(modules):
    """Returns the text of CMake/Modules.cmake."""
    return f"set(Shapeton_GROUPS Core Mesh Filtering Tools)\n# names\nset(Shapeton_MODULES{modules})\n"


class Layers(RuleTest):
    """Three modules in order: Low, Middle and High."""

    LOW, MIDDLE, HIGH = "Modules/Core/Low", "Modules/Filtering/Middle", "Modules/Filtering/High"
    LIST = "CMake/Modules.cmake"
    FILES = {
        LIST: module_list("\n  Core/Low # the first\n  Filtering/Middle\n  Filtering/High\n"),
        f"{LOW}/itk-module.cmake": declaration('Low DEPENDS ITKCommon DESCRIPTION "${DOCUMENTATION}"'),
        f"{MIDDLE}/itk-module.cmake": declaration("Middle DEPENDS Low"),
        f"{HIGH}/itk-module.cmake": declaration("High\n  ENABLE_SHARED\n  DEPENDS Middle\n  TEST_DEPENDS ITKGoogleTest"),
        f"{LOW}/include/itkLow.h": '#include "LowExport.h"\n#include "itkImage.h"\n#include <vector>\n',
        f"{MIDDLE}/include/itkMiddle.h": '#include "itkLow.h"\n',
        f"{HIGH}/include/itkHigh.h": '  #  include <itkLow.h>\n#include "itkMiddle.h"\n',
        f"{HIGH}/test/itkHighGTest.cxx": "#include <gtest/gtest.h>\n",
        f"{HIGH}/src/itkHigh.cxx": '#include "itkHigh.h"\n#include "MiddleExport.h"\n',
    }

    def check_layers(self, files, *expected):
        """Checks that the faults contain the expected ones, or that there are none."""
        faults = self.results(layers.layers_kept, files)
        if not expected:
            self.assertEqual(faults, [])
        for fault in expected:
            self.assertIn(fault, faults)

    def test_system_headers_outside_of_their_folder(self):
        text = '#include <vector>\n#  include <sys/wait.h>\n#include "unistd.h"\n'
        self.check(layers.system_headers, {f"{layers.POSIX_FOLDER}/a.cxx": text, f"{self.LOW}/test/a.cxx": text})
        for file in (f"{self.LOW}/src/a.cxx", "Applications/Cutter/Cutter.cxx", "Wrapping/Python/src/a.h"):
            advice = f"only {layers.POSIX_FOLDER} may, see shapetonOperatingSystem.h"
            self.check(layers.system_headers, {file: text}, f"{file}:2: includes sys/wait.h; {advice}",
                       f"{file}:3: includes unistd.h; {advice}")

    def check_declaration(self, module, text, *expected):
        file = f"{module}/itk-module.cmake"
        self.check_layers({file: text if "itk_module(" in text else declaration(text)},
                          *(f"{file}: {fault}" for fault in expected))

    def test_good_order(self):
        self.check_layers({})
        names = {f"{self.LOW}/include/itkLow.h": '#include "ShapetonLowExport.h"\n#include "itkImage.h"\n'}
        names |= {name: text.replace("Low", "ShapetonLow", 1) if "itk-module" in name else text
                  for name, text in self.FILES.items() if "itkLow.h" not in name}
        self.check_layers(names)

    def test_includes(self):
        file = f"{self.LOW}/src/itkLow.cxx"
        self.check_layers({file: '#include "itkLow.h"\n#include "itkHigh.h"\n'},
                          f"{file}:2: includes itkHigh.h of High, a later module")
        self.check_layers({file: '#include "../include/itkLow.h"\n'},
                          f"{file}:1: includes ../include/itkLow.h, which leaves its folder")
        fault = "includes itkLow.h of Low, which its itk-module.cmake does not name"
        for text in ("Middle DEPENDS ITKCommon", "Middle PRIVATE_DEPENDS Low"):
            self.check_layers({f"{self.MIDDLE}/itk-module.cmake": declaration(text)},
                              f"{self.MIDDLE}/include/itkMiddle.h:1: {fault}", f"{self.HIGH}/include/itkHigh.h:1: {fault}")
        files = {f"{self.MIDDLE}/itk-module.cmake": declaration("Middle TEST_DEPENDS Low"),
                 f"{self.MIDDLE}/include/itkMiddle.h": "", f"{self.HIGH}/include/itkHigh.h": '#include "itkMiddle.h"\n',
                 f"{self.MIDDLE}/test/itkMiddleGTest.cxx": '#include "itkLow.h"\n'}
        self.check_layers(files)
        self.check_layers({**files, f"{self.MIDDLE}/src/itkMiddle.cxx": '#include "itkLow.h"\n'},
                          f"{self.MIDDLE}/src/itkMiddle.cxx:1: {fault}")

    def test_dependencies(self):
        self.check_declaration(self.LOW, "Low PRIVATE_DEPENDS ITKCommon High",
                               "PRIVATE_DEPENDS names High, which is not an earlier module")
        self.check_declaration(self.LOW, "Low DEPENDS Low", "DEPENDS names Low, which is not an earlier module")
        self.check_declaration(self.LOW, "Low DEPENDS Lower", "DEPENDS names Lower, which is not a module")
        self.check_declaration(self.MIDDLE, "Middle DEPENDS Low ITKIONRRD",
                               "DEPENDS names ITKIONRRD, which no file in include uses")
        self.check_layers({f"{self.HIGH}/include/itkHigh.h": "", f"{self.HIGH}/src/itkHigh.cxx": '#include "itkHigh.h"\n'},
                          f"{self.HIGH}/itk-module.cmake: DEPENDS names Middle, which no file in include uses")

    def test_declarations(self):
        self.check_declaration(self.LOW, "Lo DEPENDS ITKCommon", "must declare itk_module(Low) or itk_module(ShapetonLow)")
        self.check_declaration(self.LOW, "itk_module(Low DEPENDS ITKCommon)\n", "must set EXCLUDE_FROM_DEFAULT, so that "
                               "ITK does not build the module by default")
        self.check_declaration(self.LOW, 'Low DEPENDS ITKCommon DESCRIPTION "Boxes; spheres"',
                               "contains a semicolon, which ITK takes for an argument separator")
        self.check_layers({f"{self.HIGH}/include/itkLow.h": ""},
                          f"{self.HIGH}/include/itkLow.h: the header name itkLow.h is taken by the module Low")

    def test_list(self):
        good = " Core/Low Filtering/Middle Filtering/High"
        for modules, fault in (
                ("", "does not list any module"),
                (good + " Mesh/New", "names the module Mesh/New, which has no itk-module.cmake"),
                (good + " Core/Low", "names the module Low twice"),
                (" Filtering/Middle Core/Low Filtering/High", "names the module Low of Core after a module of Filtering"),
                (" Core/Low Shapes/Middle Filtering/High", "names the module Middle in the unknown group Shapes")):
            self.check_layers({self.LIST: module_list(modules)}, f"{self.LIST}: {fault}")
        self.check_layers({"Modules/Mesh/New/itk-module.cmake": declaration("New DEPENDS ITKCommon")},
                          "Modules/Mesh/New/itk-module.cmake: is not listed in CMake/Modules.cmake")

    def test_graph(self):
        self.check(layers.graph, {}, "Core/Low:", "Filtering/Middle: Low", "Filtering/High: Middle",
                   "3 modules, 2 arrows, 3 public headers, 2 used outside their module")

    def test_texts_of_libraries(self):
        file = f"{self.HIGH}/src/itkHigh.cxx"
        self.check(layers.library_texts, {})
        self.check(layers.library_texts, {file: '#include "itkHigh.h"\nnamespace itk\n{\n}\n'},
                   f"{file}:2: opens the namespace itk; use shapeton")
        text = 'const char * text = "use --option 3";\n'
        self.check(layers.library_texts, {file: text},
                   f'{file}:1: names an option; name the parameter, for example: the parameter \\"p\\"')
        self.check(layers.library_texts, {file: 'int i; // "a -- b"\n', "Modules/Tools/Line/src/itkLine.cxx": text})


class PageScripts(RuleTest):
    FILES = {"a/scripts/a.mjs": "import { b } from './b.mjs';\n\nconst c = b + 'http';\n",
             "a/scripts/b.mjs": "export const b = 1; // var x\n"}

    def check_script(self, text, fault, line=3):
        name = "a/scripts/a.mjs"
        self.check(page_scripts.page_scripts, {name: f"import {{ b }} from './b.mjs';\nb();\n{text}"}, f"{name}:{line}: {fault}")

    def test_lines(self):
        self.check(page_scripts.page_scripts, {})
        for text, fault in (("b(fetch);", "uses the network"), ("b('https://example.org');", "contains a network address"),
                            ("eval('b');", "evaluates text as code"), ("var x;", "is not allowed"),
                            ("b(b == 1);", "compares without ==="), ("b(); ", "ends with a blank"),
                            ("b('\t');", "contains a tab"), ("b.innerHTML = b;", "creates elements from nonconstant text"),
                            (f"b('{'x' * 140}');", "has more than 140 characters")):
            self.check_script(text, fault)

    def test_functions(self):
        self.check_script("function x() {\n" + "  b();\n" * 60 + "}\n", "is a function of 61 lines, more than 60")
        self.check_script("class X {\n  x() {\n" + "    b();\n" * 60 + "  }\n}\n", "is a function of 61 lines, more than 60", 4)

    def test_names(self):
        self.check_script("import { x } from 'node:fs';", "imports x and does not use it", 1)
        self.check_script("import { x } from 'fs';\nx();", "imports the package fs", 1)
        self.check_script("import { x } from './x.mjs';\nx();", "imports ./x.mjs, which is missing", 1)
        self.check_script("export const x = 1;", "exports x, which no module imports", 1)
        self.check(page_scripts.page_scripts, {"a/scripts/c.mjs": "const b = 2;\n"},
                   "a/scripts/c.mjs:1: has the top-level name b of b.mjs")

    @unittest.skipUnless(shutil.which("node"), "node is not installed")
    def test_syntax(self):
        self.check_script("b(;", "SyntaxError: Unexpected token ';'")
