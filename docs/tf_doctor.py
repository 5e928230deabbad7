"""Write docs/tf_doctor.md: the findings of `tfloom tf doctor`, from its catalogue.

A test compares the page with what this writes.
"""

from __future__ import annotations

from pathlib import Path

from tfloom.cli.tf.doctor import LIMIT_OPTIONS
from tfloom.tf2_tools.diagnosis.catalogue import GAP_PERIODS, GROUPS, KINDS, MAX_SPIN_DEG_S, Kind, Limits
from tfloom.tf2_tools.diagnosis.value_checks import SUDDEN

PAGE = Path(__file__).with_suffix(".md")

HEAD = """\
# `tfloom tf doctor`: what is wrong with the transforms, and who causes it

```
tfloom tf doctor                      # listens to the graph for 5 s
tfloom tf doctor --topics             # also checks the frames in the headers of all topics
tfloom tf doctor --seconds 20 --json  # a report for programs
tfloom tf doctor recording.mcap       # a bag, or a YAML file of static transforms
tfloom tf doctor --explain TF101      # a row of this page
```

DDS tells the publisher of each message, and each participant lists the endpoints of its nodes: so each finding names
the nodes that cause it. A recording does not hold the publishers; its findings name edges and topics alone, and those
on several publishers of one frame and on quality of service need the graph. The doctor has no node that is listed,
and sends nothing; with `--topics`, it subscribes to each topic whose messages begin with a header, and reads the
header alone. On DDS it reads requests to buffer servers (`tf2_buffer_server`) that are sent while it listens, and
stands beside each server with a publisher of responses as well, because clients on Fast DDS compare the numbers of
both ends. Where /clock is published, stamps are compared with its time.

## Exit code

| code | meaning |
|---|---|
| 0 | no finding, or warnings alone |
| 1 | an error; with `--strict`, any finding |
| 2 | wrong arguments, or nothing could be read |

An error is a finding by which lookups fail or give wrong values. A warning may be on purpose, or makes lookups fail at
times. `--ignore CODE ...` leaves out findings, in the report and for the exit code.

"""


def page() -> str:
    """Return the page."""
    parts = [HEAD, _limits(), _table()]
    for digit, title in GROUPS.items():
        parts.append(f"\n## {title}\n")
        parts += [_section(kind) for code, kind in KINDS.items() if code[2] == digit]
    return "".join(parts).rstrip() + "\n"


def _limits() -> str:
    rows = [
        f"| `{option}` | {Limits._field_defaults[field]:g} | {placeholder} | {summary} |"
        for option, (field, placeholder, summary) in LIMIT_OPTIONS.items()
    ]
    notes = (
        f"\nA pause is at least {GAP_PERIODS:g} mean periods long. A step is a teleport only if it is {SUDDEN:g} times "
        "as fast as the others, because all steps of a fast vehicle, or of a spinning sensor, are long; a turn only "
        f"above {MAX_SPIN_DEG_S:g} deg/s.\n\n"
    )
    return "\n".join(["## Thresholds\n", "| option | usual | unit | |", "|---|---|---|---|", *rows, notes])


def _table() -> str:
    rows = [
        f"| [{code}](#{code.lower()}) | {kind.severity.value} | {kind.title} |"
        for code, kind in KINDS.items()
    ]
    return "\n".join(["## All codes\n", "| code | | |", "|---|---|---|", *rows, ""])


def _section(kind: Kind) -> str:
    return (
        f"\n### {kind.code}\n\n"
        f"**{kind.title[0].upper()}{kind.title[1:]}** ({kind.severity.value})\n\n"
        f"Meaning: {kind.meaning}\n\nCause: {kind.cause}\n\nMend: {kind.mend}\n"
    )


if __name__ == "__main__":
    PAGE.write_text(page(), "utf-8")
