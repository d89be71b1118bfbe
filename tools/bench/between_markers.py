"""between_markers.py DOCUMENT NAME TABLE: puts a table between the markers of its name in a document.

The markers are the lines `<!-- NAME: begin -->` and `<!-- NAME: end -->`.
"""

import sys


def main(document, name, table):
    with open(document, encoding="utf-8") as file:
        head, rest = file.read().split(f"<!-- {name}: begin -->\n")
    with open(table, encoding="utf-8") as file:
        between = file.read()
    end = f"<!-- {name}: end -->\n"
    with open(document, "w", encoding="utf-8") as file:
        file.write(f"{head}<!-- {name}: begin -->\n\n{between}\n{end}{rest.split(end)[1]}")


if __name__ == "__main__":
    main(*sys.argv[1:])
