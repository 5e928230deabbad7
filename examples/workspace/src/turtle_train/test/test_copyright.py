from ament_copyright.main import main
import pytest


# Remove this line when the source files have a notice of copyright.
@pytest.mark.skip(reason='the generated files have no notice of copyright')
@pytest.mark.copyright
@pytest.mark.linter
def test_copyright():
    assert main(argv=['.', 'test']) == 0, 'files without copyright or licence'
