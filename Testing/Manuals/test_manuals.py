"""The manual pages and completions of the tools in SHAPETON_TOOLS, which are in SHAPETON_MANUALS."""

import os
import pty
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

FOLDER, TOOLS = Path(os.environ["SHAPETON_MANUALS"]), Path(os.environ["SHAPETON_TOOLS"])
SCRIPT = Path(__file__).parents[2] / "CMake/manuals.py"
DESCRIPTIONS = sorted(TOOLS.glob("*.xml"))
PAGES = [FOLDER / f"man/man1/{description.stem}.1.gz" for description in DESCRIPTIONS]
SHELLS = {  # the command, and what makes it complete the arguments of a tool, which then are written to a file
    "bash": (
        "bash --norc --noprofile -i",
        f"source {FOLDER}/bash-completion/completions/TOOL; TOOL() {{ printf '%s\\n' \"$@\" >arguments; }}",
    ),
    "zsh": (
        "zsh -f -i",
        f"fpath+=({FOLDER}/zsh/vendor-completions); autoload compinit; compinit -uD; TOOL() {{ print -l -- $@ >arguments; }}",
    ),
    "fish": (
        "fish --no-config -i",
        f"source {FOLDER}/fish/vendor_completions.d/TOOL.fish; function TOOL; printf '%s\\n' $argv >arguments; end",
    ),
}
STANDARD = {"--quiet", "--echo", "--returnparameterfile", "--processinformationaddress", "--xml", "--version", "--help"}

# Text with every character that roff changes, at the start of a line, too.
DIFFICULT = ".br 'quoted' \"twice\" `code` C:\\dir\\new r^2 ~ -1 --faces x-ray " + " ".join([".TH 'x"] * 40) + "."
DESCRIPTION = f"""<?xml version="1.0" encoding="utf-8"?>
<executable><category>Shapeton.Test</category><title>Test</title><version>1.0.0</version>
<description>Tests roff. {DIFFICULT}</description>
<parameters><label>Group</label><description>{DIFFICULT}</description>
<string><name>text</name><longflag>text</longflag><label>Text</label><description>{DIFFICULT}</description></string>
</parameters></executable>
"""


def output_of(*command, **environment):
    """Returns stdout; stderr must be empty."""
    result = subprocess.run(command, capture_output=True, text=True, env={**os.environ, **environment}, check=True)
    assert not result.stderr, result.stderr
    return result.stdout


def rendered(page, locale="C"):
    """Returns the text of a page with one line per paragraph."""
    command = ("man", "--warnings", "--no-hyphenation", "--no-justification", "-l", page)
    return output_of(*command, MANWIDTH="10000", LC_ALL=locale)


def words(text):
    return " ".join((text or "").split())


def parameters_of(description):
    """Returns the parameters of a tool, without return values."""
    root = ElementTree.parse(description).getroot()
    return [p for p in root.iterfind("parameters/*") if p.find("longflag") is not None or p.find("index") is not None]


def options_of(description):
    return {"--" + p.findtext("longflag") for p in parameters_of(description) if p.find("longflag") is not None} | STANDARD


def make(folder, *descriptions, **environment):
    """Runs the script and returns the bytes of its files by name."""
    output_of(sys.executable, "-B", SCRIPT, folder, "Sat, 31 Jan 2026 00:00:00 +0000", *descriptions, **environment)
    return {str(file.relative_to(folder)): file.read_bytes() for file in Path(folder).rglob("*") if file.is_file()}


class Manuals(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def test_equal_input_gives_equal_bytes(self):
        first, second = (make(self.folder / seed, *DESCRIPTIONS, PYTHONHASHSEED=seed) for seed in "12")
        self.assertEqual(len(first), 4 * len(DESCRIPTIONS))
        self.assertEqual([name for name in first if first[name] != second[name]], [])


class Pages(Manuals):
    def test_pages_are_valid(self):
        self.assertTrue(PAGES)
        for page in PAGES:
            rendered(page)
            self.assertEqual(output_of("mandoc", "-Tlint", "-Wstyle", page), "")

    def test_each_has_a_summary(self):
        for page in PAGES:
            self.assertRegex(output_of("lexgrog", page), f'"{page.name[:-5]} - [A-Za-z][^"]+"')

    def test_each_parameter_has_its_description_words_range_and_default(self):
        for description, page in zip(DESCRIPTIONS, PAGES):
            text = rendered(page)
            for parameter in parameters_of(description):
                name = ("" if parameter.find("longflag") is None else "--") + parameter.findtext("name")
                item = re.search(rf"^ +{name}( [a-z|,.]+)?\s+(.+)", text, re.M)
                self.assertTrue(item, f"{page}: {name}")
                self.assertTrue(words(item[2]).startswith(words(parameter.findtext("description"))), item[2])
                for fact in ("element", "constraints/minimum", "constraints/maximum", "default"):
                    for value in parameter.findall(fact) if parameter.tag != "boolean" else []:
                        self.assertIn(words(value.text), item[2])

    def test_the_options_are_those_of_help(self):
        for description, page in zip(DESCRIPTIONS, PAGES):
            pattern = r"^ {1,8}(?:-\w, )?(--\w+)"
            options = sorted(re.findall(pattern, output_of(TOOLS / description.stem, "--help"), re.M))
            self.assertEqual(sorted(re.findall(pattern, rendered(page), re.M)), options)
            self.assertEqual(sorted(options_of(description)), options)

    def test_any_text_is_rendered_unchanged(self):
        (self.folder / "Test.xml").write_text(DESCRIPTION)
        make(self.folder / "share", self.folder / "Test.xml")
        page = self.folder / "share/man/man1/Test.1.gz"
        for text in (rendered(page), rendered(page, "C.UTF-8").replace("\N{HYPHEN}", "-")):
            self.assertEqual(words(text).count(words(DIFFICULT)), 3)
        self.assertEqual(output_of("mandoc", "-Tlint", "-Wwarning", page), "")


class Completion(Manuals):
    def typed(self, shell, tool, keys):
        """Returns the arguments that an interactive shell passes to a tool for these keys; a tab completes a word."""
        command, start = SHELLS[shell]
        process, terminal = pty.fork()
        if process == 0:
            os.chdir(self.folder)
            os.execvpe(shell, command.split(), {**os.environ, "TERM": "dumb", "HISTFILE": "", "HOME": str(self.folder)})
        os.write(terminal, f"{start.replace('TOOL', tool)}\n{tool} {keys}\nexit\n".encode())
        output = b""
        try:
            while block := os.read(terminal, 4096):
                output += block
        except OSError:  # the shell has ended
            os.waitpid(process, 0)
        os.close(terminal)
        self.assertTrue((self.folder / "arguments").exists(), output.decode())
        return (self.folder / "arguments").read_text().splitlines()

    def check_tabs(self, shell):
        for name in ("series of June", "other.nrrd"):
            (self.folder / name).touch()
        arguments = self.typed(shell, "VirtualColonoscopy", "seri\t --inputIsL\t --posi\tpro\t --topology=ra\t --lumen oth\t")
        self.assertIn(arguments[2:-3], (["--position", "prone"], ["--position=prone"]))
        self.assertEqual(arguments[:2] + arguments[-3:], ["series of June", "--inputIsLumen", "--topology=raw", "--lumen", "other.nrrd"])

    def test_a_tab_completes_options_words_and_file_names_in_bash(self):
        self.check_tabs("bash")

    def test_a_tab_completes_options_words_and_file_names_in_zsh(self):
        self.check_tabs("zsh")

    def test_a_tab_completes_options_words_and_file_names_in_fish(self):
        self.check_tabs("fish")

    def test_each_option_is_completed(self):
        for description in DESCRIPTIONS:
            name = description.stem
            script = f"source {FOLDER}/bash-completion/completions/{name}; COMP_WORDS=({name} --); COMP_CWORD=1; _shapeton_{name}"
            options = output_of("bash", "-c", script + '; printf "%s\\n" "${COMPREPLY[@]}"').split()
            self.assertEqual(sorted(options), sorted(options_of(description)))


if __name__ == "__main__":
    for program in ("man", "lexgrog", "mandoc", "zsh", "fish"):
        if not shutil.which(program):
            print(f"skipped: {program} is not installed")
            sys.exit()
    unittest.main()
