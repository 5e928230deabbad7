"""`python -m tfloom.cli`: the command, for where its script isn't on PATH."""

import sys

from tfloom.cli.main import main

sys.exit(main())
