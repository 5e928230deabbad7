"""`python -m tfloom`: the command `tfloom`, for where its script isn't on PATH."""

import sys

from tfloom.cli.main import main

sys.exit(main())
