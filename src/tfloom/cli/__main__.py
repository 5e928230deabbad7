"""`python -m tfloom.cli`: the command, for where its script isn't on PATH."""

import sys

from tfloom.cli.start import main

sys.exit(main())
