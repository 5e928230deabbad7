"""`python -m tfloom`: the command `tfloom`, for where its script isn't on PATH."""

import sys

from tfloom.cli.start import main

sys.exit(main())
