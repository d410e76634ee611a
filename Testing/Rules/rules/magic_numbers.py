"""Numbers in sources that clang-tidy reports, because they have no name. These numbers need no name:

  - the value of a declaration, such as the default of an option: the declaration is the name
  - the range of an option (RequireParameter): its message states the range
  - shares of progress: they estimate times and do not affect results
  - the index of an element, the number of bits of a shift, and a mask of bits
  - hexadecimal numbers: patterns of bits, codes of characters
"""

import re

NAMED = re.compile(r"\w[>\]]* +[*&]?\w+(\[\w+\])? *(= |\{ ?)-?[\d.][\w.+-]* ?\}?[;,)]"
                   r"|RequireParameter\(|[pP]rogress\w*(\.Part|\.)?\(")
BITS = re.compile(r"(\[|<<|>>|&|\||\^)=? ?$")


def is_fault(line, column, message):
    """Whether a report at a column of a line concerns a number without a name, or a file that does not compile."""
    is_number = "magic number" in message
    return not is_number or not (message.lower().startswith("0x") or NAMED.search(line) or BITS.search(line[:column - 1]))
