(use-modules (pizarra test-checks) (pizarra echo))

(check "a datum comes back" (echo '(a "b" 1)) '(a "b" 1))

(finish-checks)
