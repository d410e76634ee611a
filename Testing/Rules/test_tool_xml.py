"""Each rule for module descriptions rejects a made-up fault."""

import unittest

from rules.tool_xml import faults_of_xml

GOOD = """<?xml version="1.0" encoding="utf-8"?>
<executable>
  <category>Shapeton</category>
  <title>Good</title>
  <description>Does something.</description>
  <version>1.2.3</version>
  <documentation-url></documentation-url>
  <license>Apache-2.0</license>
  <contributor>Somebody</contributor>
  <acknowledgements></acknowledgements>
  <parameters>
    <label>IO</label>
    <description>Input and output.</description>
    <image><name>inputVolume</name><label>Input</label><channel>input</channel><index>0</index>
      <description>What is read.</description></image>
    <image type="label" fileExtensions=".nrrd,.nii.gz" reference="inputVolume"><name>outputVolume</name>
      <label>Output</label><channel>output</channel><index>1</index><description>What is written.</description>
      </image>
    <directory><name>folder</name><label>Folder</label><channel>input</channel><index>2</index><description>What is searched.</description>
      </directory>
    <string><name>seriesUID</name><longflag>seriesUID</longflag><label>Series</label>
      <description>The series to take.</description></string>
    <boolean><name>resampleGaps</name><longflag>resampleGaps</longflag><label>Resample gaps</label>
      <description>Fill gaps.</description><default>false</default></boolean>
    <boolean><name>deshear</name><longflag>deshear</longflag><label>Deshear</label>
      <description>Undo a tilt.</description></boolean>
    <boolean><name>dropDuplicates</name><longflag>dropDuplicates</longflag><label>Drop duplicates</label>
      <description>Keep the first.</description><default>false</default></boolean>
  </parameters>
  <parameters advanced="true">
    <label>Settings</label>
    <description><![CDATA[Numbers & names.]]></description>
    <double><name>gamma</name><flag>g</flag><longflag>gamma</longflag><label>Gamma</label>
      <description>The exponent.</description><default>1.5</default>
      <constraints><minimum>0.5</minimum><maximum>10</maximum><step>0.1</step></constraints></double>
    <double-vector><name>window</name><flag>w</flag><longflag>window</longflag><label>Window</label>
      <description>Two numbers.</description><default>-1,1e3</default></double-vector>
    <string-enumeration><name>solver</name><longflag>solver</longflag><label>Solver</label>
      <description>The method.</description><default>explicit</default>
      <element>chebyshev</element><element>explicit</element></string-enumeration>
    <point multiple="true" coordinateSystem="lps"><name>seed</name><longflag>seed</longflag><label>Seed</label>
      <description>A place.</description></point>
    <integer><name>threads</name><longflag>threads</longflag><label>Threads</label>
      <description>How many.</description><default>0</default><constraints><minimum>0</minimum></constraints>
      </integer>
    <double><name>mean</name><label>Mean</label>
      <channel>output</channel><description>A value that is returned.</description></double>
  </parameters>
</executable>
"""

# Replacing the first text of a row by the second one in the good description violates the rule that the third one
# names.
BREAKS = r"""
<?xml | \n<?xml | must begin with <?xml
</executable> | | is not well-formed
<description>Does something.</description> | <description>Does this & that.</description> | is not well-formed
<executable> | <executable name="x"> | <executable> has no attribute "name"
<title>Good</title> | <title>Good</title><logo>x</logo> | <logo> is not allowed in <executable>
<title>Good</title> | | lacks <title>
<title>Good</title> | <title>Good</title><title>Better</title> | <title> appears twice
<category>Shapeton</category> | <category></category> | lacks <category>
<contributor>Somebody</contributor> | | lacks <contributor>
<version>1.2.3</version> | <version>1.2.4</version> | <version> is "1.2.4", must be "1.2.3"
<version>1.2.3</version> | | lacks <version>
Apache-2.0 | MIT | <license> is "MIT"
Does something. | Does something | <executable> must end with a period
Does something. | | <executable> lacks <description>
<title>Good</title> | <title><b>Good</b></title> | <title> contains elements where only text is allowed
<label>IO</label> | | <parameters> lacks <label>
<label>IO</label> | <label>IO</label>stray | contains unexpected text "stray"
Input and output. | Input and output | <parameters> must end with a period
advanced="true" | advanced="yes" | attribute "advanced" of <parameters> is "yes"
</executable> | <parameters><label>L</label></parameters></executable> | does not contain any parameter
<label>Settings</label> | <label>Settings</label><number></number> | <number> is not allowed in <parameters>
coordinateSystem="lps" | coordinateSystem="LPS" | attribute "coordinateSystem" of <point>
type="label" | type="mask" | attribute "type" of <image> is "mask"
type="label" | kind="label" | <image> has no attribute "kind"
.nii.gz | nii.gz | file extension "nii.gz"
<label>Gamma</label> | | <double> gamma lacks <label>
The exponent. | | <double> gamma lacks <description>
The exponent. | The exponent | <double> gamma must end with a period
<label>Gamma</label> | <label>Gamma</label><unit>mm</unit> | <unit> is not allowed in <double>
<longflag>gamma</longflag> | <longflag alias="old">gamma</longflag> | <longflag> has no attribute "alias"
<name>gamma</name> | | <name> must be camelCase
<name>gamma</name> | <name>Gamma</name> | <name> must be camelCase
<name>gamma</name> | <name>gam-ma</name> | <name> must be camelCase
<name>gamma</name> | <name>2gamma</name> | <name> must be camelCase
<longflag>gamma</longflag> | <longflag>power</longflag> | <longflag> "power" differs from <name>
<longflag>gamma</longflag> | <longflag>--gamma</longflag> | <longflag> "--gamma" differs from <name>
<longflag>gamma</longflag> | | a <flag> needs a <longflag>
<flag>g</flag> | <flag>gg</flag> | <flag> "gg" must be one letter
<flag>g</flag> | <flag>1</flag> | <flag> "1" must be one letter
<flag>g</flag> | <flag>h</flag> | <flag> "h" must be one letter other than h
<flag>g</flag> | <flag>w</flag> | <flag> w is taken
<name>window</name> | <name>gamma</name> | the name is taken
<name>gamma</name> | <name>xml</name> | the name is reserved
<channel>input</channel> | <channel>in</channel> | <channel> is "in"
<channel>input</channel> | | inputVolume lacks <channel>
<longflag>seriesUID</longflag> | | seriesUID needs a <longflag> or an <index>
<channel>output</channel><description>A value | <description>A value | mean needs a <longflag>
<index>0</index> | <index>0</index><longflag>inputVolume</longflag> | <index> excludes <flag> and <longflag>
<longflag>seed</longflag> | <index>2</index> | seed cannot be positional
<longflag>deshear</longflag> | <index>2</index> | deshear cannot be positional
<index>0</index> | <index>first</index> | <index> must be a non-negative integer
<index>1</index> | <index>0</index> | <index> 0 is taken
<index>1</index> | <index>2</index> | must be consecutive and start at 0
<image> | <image multiple="true"> | only the last positional argument may be multiple
<index>0</index> | <index>0</index><default>x</default> | inputVolume cannot have a <default>
<longflag>seriesUID</longflag> | <index>2</index><default>x</default> | is required and cannot have a <default>
<minimum>0.5</minimum> | <minimum>low</minimum> | <minimum> "low" is not a number
<minimum>0.5</minimum> | <minimum>11</minimum> | <minimum> is greater than <maximum>
<step>0.1</step> | <step>0</step> | <step> must be greater than 0
<step>0.1</step> | <pace>0.1</pace> | <pace> is not allowed in <constraints>
<element>chebyshev</element> | <element>chebyshev</element><constraints></constraints> | solver cannot have <constraints>
<default>1.5</default> | <default>0.1</default> | <default> 0.1 is outside its constraints
<default>1.5</default> | <default>11</default> | <default> 11 is outside its constraints
<default>1.5</default> | <default>1,5</default> | <default> "1,5" is not a number
<default>1.5</default> | | gamma lacks <default>
<default>-1,1e3</default> | <default>-1,</default> | <default> "" is not a number
<default>-1,1e3</default> | <default>-1, 1</default> | <default> " 1" is not a number
<default>explicit</default> | <default>implicit</default> | "implicit" is not one of its elements
<default>explicit</default> | | solver lacks <default>
<element>chebyshev</element> | <element>explicit</element> | <element> "explicit" appears twice
<element>chebyshev</element><element>explicit</element> | | solver lacks <element>
<point | <integer-enumeration><element>x</element></integer-enumeration><point | <element> "x" is not a number
<constraints> | <constraints unit="mm"> | <constraints> has no attribute "unit"
<label>Gamma</label> | <label>Gamma</label><element>1.5</element> | is not an enumeration but has <element>
<default>false</default> | <default>true</default> | the <default> of a boolean must be false
<default>0</default> | <default>1</default> | threads must be an <integer>
<default>0</default> | <default>0.0</default> | <default> "0.0" is not a number of the type
<minimum>0</minimum> | <minimum>1</minimum> | threads must be an <integer>
<name>threads</name><longflag>threads</longflag> | <name>cores</name><longflag>cores</longflag> | the option threads is missing
<channel>input</channel><index>2 | <channel>output</channel><index>2 | folder: must be a <file>
<index>2</index><description>What is searched | <longflag>folder</longflag><description>What is searched | folder: must be a <file>
reference="inputVolume" | reference="input" | the reference to "input" does not match any parameter
<name>deshear</name><longflag>deshear</longflag> | <name>shear</name><longflag>shear</longflag> | must have the option deshear
<name>seriesUID</name><longflag>seriesUID</longflag> | <name>series</name><longflag>series</longflag> | must have the option seriesUID
<name>gamma</name> | <name>unit</name> | unit must be a <string-enumeration> option
<name>gamma</name> | <name>unit</name> | a tool that takes a surface must have the option component
"""


def faults(xml):
    return [str(fault) for fault in faults_of_xml(xml, "Tool.xml", "1.2.3")]


class ToolXML(unittest.TestCase):
    def test_accepts_a_good_description(self):
        self.assertEqual(faults(GOOD), [])

    def test_names_each_fault(self):
        for row in BREAKS.strip().split("\n"):
            before, after, message = row.replace(" | | ", " |  | ").split(" | ")
            with self.subTest(row):
                self.assertIn(before, GOOD)
                xml = GOOD.replace(before, after.replace(r"\n", "\n"), 1)
                self.assertIn(message, "\n".join(faults(xml)))

    def test_names_file_and_line(self):
        message = 'Tool.xml:8: <license> is "MIT", must be "Apache-2.0"'
        self.assertEqual(faults(GOOD.replace("Apache-2.0", "MIT")), [message])

    def test_rejects_other_documents(self):
        self.assertIn("must be <executable>", faults('<?xml version="1.0"?>\n<module/>')[0])
        self.assertNotEqual(faults(""), [])
