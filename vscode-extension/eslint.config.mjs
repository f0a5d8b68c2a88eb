import tseslint from 'typescript-eslint';

export default tseslint.config({ ignores: ['dist', 'bundled', 'node_modules'] }, ...tseslint.configs.recommended, {
  rules: { eqeqeq: 'error', 'no-console': 'error' },
});
